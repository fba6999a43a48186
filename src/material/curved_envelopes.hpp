// SPDX-License-Identifier: MIT
#pragma once
// Strength envelopes given by a formula or by pairs: the power curve τ = a (σ' + d)^b + c (Charles and Soares 1984),
// τ–σ' tables, and the joints of Barton and Bandis (1982).

#include "material/curved_law.hpp"
#include "material/slice_law.hpp"

namespace talus::material {

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
