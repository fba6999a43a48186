// SPDX-License-Identifier: MIT
#pragma once
// Strength envelopes given by a formula or by pairs: the power curve τ = a (σ' + d)^b + c (Charles and Soares 1984),
// τ–σ' tables, and the joints of Barton and Bandis (1982).

#include "material/curved_law.hpp"
#include "material/slice_law.hpp"

namespace talus::material {

struct PowerCurveInput {
  double power_factor = 0;    ///< a, for stresses in kPa [kPa^(1-b)]
  double power_exponent = 0;  ///< b [-]
  double power_shift = 0;     ///< d [Pa]
  double power_cohesion = 0;  ///< c [Pa]
};
inline void describe(input::Visitor& v, PowerCurveInput& in, const Users& users) {
  v.key("power_factor", in.power_factor, users.need(plain().above(0)).usual(0.05, 20).example("2"),
        "a of the power curve τ = a (σ' + d)^b + c, for stresses in kPa.");
  v.key("power_exponent", in.power_exponent, users.need(plain().above(0).at_most(1)).usual(0.4, 1).example("0.7"),
        "b of that.");
  v.key("power_shift", in.power_shift, users.allow(quantity("kPa").at_least(0)).example("1"),
        "d of that, an effective stress that acts beside σ'.");
  v.key("power_cohesion", in.power_cohesion, users.allow(quantity("kPa").at_least(0)).example("2"), "c of that.");
}

struct PowerCurve : CurvedSoil<PowerCurve> {
  static constexpr Traits traits{.word = "power_curve",
                                 .meaning = "soil with the curved envelope τ = a (σ' + d)^b + c",
                                 .title = "power curve",
                                 .serves_slices = true,
                                 .is_opaque = true,
                                 .paragraphs = {"mohr_coulomb"},
                                 .assumption =
                                     "{}: curved envelope τ = a (σ' + d)^b + c without tensile strength, perfectly "
                                     "plastic. LEM uses its tangent at the normal stress of "
                                     "each base, FEM and MPM return the stress to the envelope."};

  using Input = Needs<YoungInput, PoissonInput, PowerCurveInput, FlowRatio>;
  static Properties list_properties(const Input& in);
  static PowerEnvelope make_envelope(const Input& in);
  explicit PowerCurve(const CurvedLaw& law) : CurvedSoil(law) {}
};

struct StrengthTableInput {
  std::vector<double> normal_stresses;  ///< σ'_n, increasing [Pa]
  std::vector<double> shear_strengths;  ///< τ [Pa]
};
inline void describe(input::Visitor& v, StrengthTableInput& in, const Users& users) {
  v.key("normal_stresses", in.normal_stresses, users.need(quantity("kPa").at_least(0)).example("[0, 50, 200]"),
        "Effective normal stresses of a strength envelope, increasing.");
  v.key("shear_strengths", in.shear_strengths, users.need(quantity("kPa").at_least(0)).example("[5, 40, 130]"),
        "Shear strengths at them; straight between, and beyond the last with the last slope.");
}

struct StrengthTable : CurvedSoil<StrengthTable> {
  static constexpr Traits traits{.word = "strength_table",
                                 .meaning = "soil with an envelope of measured pairs of normal stress and strength",
                                 .title = "strength table",
                                 .serves_slices = true,
                                 .is_opaque = true,
                                 .paragraphs = {"mohr_coulomb"},
                                 .assumption =
                                     "{}: envelope of given pairs of effective normal stress and shear strength, "
                                     "straight between them, without tensile strength."};

  using Input = Needs<YoungInput, PoissonInput, StrengthTableInput, FlowRatio>;
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  static StrengthPairs make_envelope(const Input& in);
  explicit StrengthTable(const CurvedLaw& law) : CurvedSoil(law) {}
};

struct JointInput {
  double joint_roughness = 0;    ///< JRC [-]
  double joint_strength = 0;     ///< JCS [Pa]
  double residual_friction = 0;  ///< φ_r [rad]
};
inline void describe(input::Visitor& v, JointInput& in, const Users& users) {
  v.key("joint_roughness", in.joint_roughness,
        users.need(plain().at_least(0).at_most(30)).usual_or_zero(1, 20).example("8"),
        "JRC, joint roughness coefficient.");
  v.key("joint_strength", in.joint_strength,
        users.need(quantity("MPa").above(0)).usual(0.5, 300, {{"kPa", 1e-3}, {"Pa", 1e-6}}).example("50"),
        "JCS, compressive strength of the wall of the joint.");
  v.key("residual_friction", in.residual_friction,
        users.need(quantity("deg").above(0).below(90)).usual(15, 40).example("28"),
        "φ_r, residual friction angle of the joint.");
}

/// τ = σ' tan(φ_r + JRC log10(JCS/σ')), the angle being at most 70°.
struct BartonBandis : SliceLaw<BartonBandis> {
  static constexpr Traits traits{
      .word = "barton_bandis",
      .meaning = "rock joint with the strength of Barton and Bandis, for LEM",
      .title = "Barton–Bandis joint",
      .serves_slices = true,
      .only_slices = true,
      .paragraphs = {"linear_elastic"},
      .assumption =
          "{}: joint with the strength σ' tan(φ_r + JRC log10(JCS/σ')) of Barton and Bandis (1982), its angle "
          "at most 70°."};

  using Input = Needs<YoungInput, PoissonInput, JointInput>;
  static Properties list_properties(const Input& in);
  static StrengthLaw make_strength(const Input& in);
};

}  // namespace talus::material
