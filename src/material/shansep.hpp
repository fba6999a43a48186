// SPDX-License-Identifier: MIT
#pragma once
// SHANSEP (Ladd and Foott 1974, J. Geotech. Eng. Div. 100, 763): undrained clay in total stresses whose strength
// follows from its stress history, s_u = A + S σ'_v OCR^m. The code is Tresca's with s_u as a state variable.

#include "material/strength_profile.hpp"
#include "material/tresca.hpp"

namespace talus::material {

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
