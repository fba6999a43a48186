// SPDX-License-Identifier: MIT
#pragma once
// Strengths that depend on the inclination of the plane: undrained ADP strengths, a table of c and φ, and bedding
// planes in soil or rock. `NoStrength` is a material without any.

#include "material/mohr_coulomb.hpp"
#include "material/point_law.hpp"
#include "material/slice_law.hpp"
#include "material/tresca.hpp"

namespace talus::material {

struct AdpInput {
  double direct_ratio = 1;   ///< s_uD/s_uA [-]
  double passive_ratio = 1;  ///< s_uP/s_uA [-]
};
inline void describe(input::Visitor& v, AdpInput& in, const Users& users) {
  v.key("direct_ratio", in.direct_ratio, users.need(plain().above(0).at_most(1.5)).usual(0.4, 1).example("0.63"),
        "Strength in direct simple shear over the active one, s_uD/s_uA, which `undrained_strength` or the profile "
        "gives.");
  v.key("passive_ratio", in.passive_ratio, users.need(plain().above(0).at_most(1.5)).usual(0.2, 1).example("0.35"),
        "Passive strength over the active one, s_uP/s_uA.");
}

/// s_u = s_uD + (s_uA - s_uD) sin 2α for a base that dips with the sliding by α, s_uD + (s_uP - s_uD) sin 2|α| for one
/// that rises, constant beyond 45°.
struct Adp : SliceLaw<Adp> {
  static constexpr Traits traits{
      .word = "adp",
      .meaning = "undrained clay in total stresses with active, direct and passive strength, for LEM",
      .title = "anisotropic undrained clay (ADP, total stress)",
      .serves_slices = true,
      .only_slices = true,
      .takes_water = false,
      .paragraphs = {"linear_elastic"},
      .assumption =
          "{}: undrained clay in total stresses, whose strength changes from active to direct to passive with "
          "the inclination of the base."};

  using Input = Needs<YoungInput, PoissonInput, TrescaInput, StrengthProfile, AdpInput>;
  static void check(const Input& in, const SoilFindings& findings) { Tresca::check(in, findings); }
  static Properties list_properties(const Input& in);
  static StrengthLaw make_strength(const Input& in);
  static void divide(const Input::Changeable& in, PartialDivision& division);
  static bool is_total_stress(const Input&) { return true; }
};

struct AnisotropicInput {
  std::vector<double> base_inclinations;   ///< increasing [rad]
  std::vector<double> inclined_cohesions;  ///< [Pa]
  std::vector<double> inclined_frictions;  ///< [rad]
};
inline void describe(input::Visitor& v, AnisotropicInput& in, const Users& users) {
  v.key("base_inclinations", in.base_inclinations,
        users.need(quantity("deg").at_least(-90).at_most(90)).example("[-90, -20, 20, 90]"),
        "Inclinations of a plane to the horizontal, increasing, positive where it rises with x.");
  v.key("inclined_cohesions", in.inclined_cohesions, users.need(quantity("kPa").at_least(0)).example("[20, 5, 5, 20]"),
        "Cohesions of planes with these inclinations; linear between, constant beyond.");
  v.key("inclined_frictions", in.inclined_frictions,
        users.need(quantity("deg").at_least(0).below(90)).example("[30, 22, 22, 30]"),
        "Friction angles of them; their tangents are linear between.");
}

struct Anisotropic : SliceLaw<Anisotropic> {
  static constexpr Traits traits{
      .word = "anisotropic",
      .meaning = "soil whose cohesion and friction angle depend on the inclination of the plane, by a table, for LEM",
      .title = "anisotropic strength",
      .serves_slices = true,
      .only_slices = true,
      .paragraphs = {"linear_elastic"},
      .assumption = "{}: cohesion and friction angle depend on the inclination of the base."};

  using Input = Needs<YoungInput, PoissonInput, AnisotropicInput>;
  static void check(const Input& in, const SoilFindings& findings);
  static StrengthLaw make_strength(const Input& in);
};

struct BeddingInput {
  double bedding_angle = 0;                  ///< [rad]
  double bedding_cohesion = 0;               ///< [Pa]
  double bedding_friction = 0;               ///< [rad]
  double bedding_range = 0;                  ///< A [rad]
  std::optional<double> bedding_transition;  ///< B [rad]
  double bedding_dilatancy = 0;              ///< [rad]
};
inline void describe(input::Visitor& v, BeddingInput& in, const Users& users) {
  v.key("bedding_angle", in.bedding_angle, users.need(quantity("deg").at_least(-90).at_most(90)).example("25"),
        "Inclination of the bedding to the horizontal, positive where it rises with x.");
  v.key("bedding_cohesion", in.bedding_cohesion,
        users.need(quantity("kPa").at_least(0)).usual_or_zero(0.01, 500).example("5"), "Cohesion along the bedding.");
  v.key("bedding_friction", in.bedding_friction,
        users.need(quantity("deg").at_least(0).below(90)).usual_or_zero(5, 50).example("20"),
        "Friction angle along the bedding.");
  v.key(
      "bedding_range", in.bedding_range,
      users.need(quantity("deg").at_least(0).at_most(45)).by_methods({"lem"}).example("5"),
      "LEM: planes within this angle of the bedding have its strength. A search meets a range, but an exact direction "
      "by chance only; with a wider range the factor is lower.");
  v.key("bedding_transition", in.bedding_transition, users.allow(quantity("deg").at_least(0).at_most(90)).example("15"),
        "Planes beyond this angle have the strength of the soil itself, and c and tan φ are linear between; if not "
        "given, `bedding_range`.");
  v.key("bedding_dilatancy", in.bedding_dilatancy, users.allow(quantity("deg").at_least(0).below(90)).example("0"),
        "Dilatancy angle of sliding along the bedding in FEM and MPM, at most `bedding_friction`.");
}

/// Mohr–Coulomb soil with one family of planes of another strength: the stress returns to the surface of the soil and
/// to that of the planes in turn until neither is exceeded. State variables are Mohr–Coulomb's.
class Bedding : public PointLaw<Bedding> {
 public:
  static constexpr Traits traits{
      .word = "bedding",
      .meaning = "Mohr–Coulomb soil or rock with weaker bedding planes in one direction",
      .title = "bedding planes in Mohr–Coulomb soil",
      .serves_slices = true,
      .has_friction = true,
      .is_opaque = true,
      .paragraphs = {"mohr_coulomb", "bedding"},
      .assumption =
          "{}: bedding planes of one direction have a cohesion and friction angle of their own. In LEM slip surfaces "
          "near that direction have them, in FEM, limit analysis and MPM the planes of that direction, which do not "
          "turn with the soil."};
  static constexpr int state_size = MohrCoulomb::state_size, gap_states = 1;
  static constexpr bool is_plastic = true;

  using Input = Needs<YoungInput, PoissonInput, MohrCoulombStrength, BeddingInput>;
  static Bedding make(const Input& in, const StrengthChange& change);
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  static SliceStrength find_slice_strength(const Input& in);
  static StrengthLaw make_strength(const Input& in);

  static std::vector<StateField> fields() { return {separation_field}; }
  static void show(const double* state, double /*saturation*/, double* values) { values[0] = state[1]; }
  static double find_gap(const double* state) { return state[1]; }

  template <int NS>
  Response<double> update_point(double* sigma, const double* d_epsilon, double* state,
                                const Surroundings<double>& given) const;

 private:
  Bedding(const MohrCoulomb& soil, const MohrCoulombStrength& planes, double angle);

  /// Returns the stress to the strength of the planes; false if it was within.
  template <int NS>
  bool slide(double* sigma, double* state, Response<double>& response) const;

  MohrCoulomb soil_;
  MohrCoulombStrength planes_;
  double along_[2];  ///< direction of the planes
};

struct NoStrength : SliceLaw<NoStrength> {
  static constexpr Traits traits{.word = "no_strength",
                                 .meaning = "a weight without any strength, such as refuse or water, for LEM",
                                 .title = "no strength",
                                 .serves_slices = true,
                                 .only_slices = true,
                                 .takes_water = false,
                                 .paragraphs = {"linear_elastic"},
                                 .assumption = "{}: acts by its weight alone."};

  using Input = Needs<YoungInput, PoissonInput>;
  static StrengthLaw make_strength(const Input&) {
    return {[](const StrengthPlane&) { return StrengthTangent{}; }, false, false};
  }
  static bool is_total_stress(const Input&) { return true; }
};

}  // namespace talus::material
