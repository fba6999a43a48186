// SPDX-License-Identifier: MIT
#pragma once
// SHANSEP (Ladd and Foott 1974, J. Geotech. Eng. Div. 100, 763): undrained clay in total stresses whose strength
// follows from its stress history, s_u = A + S σ'_v OCR^m. The code is Tresca's with s_u as a state variable.

#include "material/strength_profile.hpp"
#include "material/tresca.hpp"

namespace talus::material {

struct ShansepInput {
  double strength_ratio = 0;                     ///< S [-]
  double strength_exponent = 0;                  ///< m [-]
  double added_strength = 0;                     ///< A [Pa]
  std::optional<double> ocr;                     ///< [-]
  std::vector<double> profile_ocr;               ///< [-]
  std::vector<double> profile_preconsolidation;  ///< σ'_p [Pa]
};
inline void describe(input::Visitor& v, ShansepInput& in, const Users& users) {
  v.key("strength_ratio", in.strength_ratio, users.need(plain().above(0)).usual(0.1, 0.5).example("0.22"),
        "S, undrained strength of the normally consolidated soil over σ'_v.");
  v.key("strength_exponent", in.strength_exponent, users.need(plain().at_least(0)).usual(0.5, 1).example("0.8"),
        "m, exponent of the overconsolidation ratio.");
  v.key("added_strength", in.added_strength, users.allow(quantity("kPa").at_least(0)).example("5"),
        "A, a strength that is added to that of the stress history.");
  v.key("ocr", in.ocr, users.allow(plain().at_least(1)).usual(1, 20).example("2"),
        "Overconsolidation ratio of the soil; either this, `profile_ocr` or `profile_preconsolidation` is needed.");
  v.key("profile_ocr", in.profile_ocr, users.allow(plain().at_least(1)).example("[4, 2, 1]"),
        "Overconsolidation ratios along the profile.");
  v.key("profile_preconsolidation", in.profile_preconsolidation,
        users.allow(quantity("kPa").above(0)).example("[80, 70, 120]"),
        "Preconsolidation stresses σ'_p along the profile; OCR is σ'_p/σ'_v, at least 1.");
}

/// State variables as Tresca's, where 1 is s_u itself [Pa].
class Shansep : public Tresca {
 public:
  static constexpr Traits traits{
      .word = "shansep",
      .meaning =
          "undrained soil in total stresses, whose strength follows from the vertical effective stress and the "
          "overconsolidation ratio",
      .title = "SHANSEP (undrained, total stress)",
      .serves_slices = true,
      .takes_water = false,
      .paragraphs = {"mohr_coulomb"},
      .assumption =
          "{}: undrained soil in total stresses with s_u = A + S σ'_v OCR^m (SHANSEP), perfectly plastic. σ'_v is the "
          "weight and the loads above a point less its pore pressure, as if the soil were consolidated under them."};

  using Kernel = Tresca;
  using Input = Needs<YoungInput, PoissonInput, ShansepInput, StrengthProfile>;
  static Shansep make(const Input& in, const StrengthChange& change) {
    return Shansep(LinearElastic::make(in), change.factor);
  }
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  static SliceStrength find_slice_strength(const Input& in);
  static void divide(const Input::Changeable& in, PartialDivision& division);
  using Local = Shansep;
  static bool varies(const Input&) { return true; }
  void set_initial_state(const Input& in, const StateStart& start, double* state) const;

 private:
  Shansep(const LinearElastic& elastic, double factor) : Tresca(elastic, 0, factor) {}
};

/// Returns s_u [Pa] under σ'_v [Pa] at a place (x, y) and a depth under the ground [m].
double compute_shansep_strength(const ShansepInput& in, const StrengthProfile& profile, double vertical,
                                const std::array<double, 2>& at, double depth);

}  // namespace talus::material
