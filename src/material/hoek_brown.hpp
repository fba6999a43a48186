// SPDX-License-Identifier: MIT
#pragma once
// Generalised Hoek–Brown criterion of jointed rock (Hoek, Carranza-Torres and Corkum 2002):
//
//   σ1 = σ3 + σ_ci (m_b σ3/σ_ci + s)^a,  m_b = m_i exp((GSI - 100)/(28 - 14 D)),  s = exp((GSI - 100)/(9 - 3 D)),
//   a = 1/2 + (exp(-GSI/15) - exp(-20/3))/6

#include "material/curved_law.hpp"
#include "material/softening.hpp"

namespace talus::material {

HoekBrownMass make_rock_mass(const HoekBrownInput& in);

struct HoekBrown : CurvedSoil<HoekBrown> {
  static constexpr Traits traits{
      .word = "hoek_brown",
      .meaning = "jointed rock with the generalised Hoek–Brown criterion of 2002",
      .title = "Hoek–Brown",
      .serves_slices = true,
      .is_opaque = true,
      .paragraphs = {"mohr_coulomb"},
      .assumption =
          "{}: generalised Hoek–Brown criterion (2002), perfectly plastic. LEM uses the tangent to its "
          "envelope at the normal stress of each base, FEM and MPM return the stress to the envelope."};

  using Input = Needs<YoungInput, PoissonInput, HoekBrownInput, FlowRatio>;
  static Properties list_properties(const Input& in);
  static HoekBrownMass make_envelope(const Input& in) { return make_rock_mass(in.get<HoekBrownInput>()); }
  explicit HoekBrown(const CurvedLaw& law) : CurvedSoil(law) {}
};

/// Rock whose GSI falls from a peak to a residual value.
class SofteningHoekBrown : public SofteningLaw<SofteningHoekBrown> {
 public:
  static constexpr Traits traits{
      .word = "softening_hoek_brown",
      .meaning = "the same with a GSI that falls to a residual value with plastic shear strain",
      .title = "Hoek–Brown with softening",
      .serves_slices = true,
      .softens = true,
      .is_opaque = true,
      .paragraphs = {"mohr_coulomb", "softening"},
      .assumption =
          "{}: the GSI of the Hoek–Brown criterion falls linearly with plastic shear strain in MPM, and in FEM with "
          "[fem] softening = \"progressive\". Otherwise FEM, LEM and limit analysis use the peak or the residual "
          "strength of `limit_strength` everywhere."};
  using Input = Needs<YoungInput, PoissonInput, HoekBrownInput, ResidualIndex, SofteningRange, FlowRatio>;
  static SofteningHoekBrown make(const Input& in, const StrengthChange& change);
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  static SliceStrength find_slice_strength(const Input& in);
  using Limit = HoekBrown;
  static void stop_softening(const Input::Changeable& in);

  template <int NS>
  Response<double> update_softened(double strain, double* sigma, const double* d_epsilon, double* state,
                                   const Surroundings<double>& around) const {
    return make_frozen(strain).update_point<NS>(sigma, d_epsilon, state, around);
  }
  /// Returns the perfectly plastic law of the rock after a softening strain [-].
  CurvedLaw make_frozen(double strain) const { return {*this, find_mass(strain), dilatancy_ratio_, factor_}; }
  const SofteningRange& range() const { return range_; }
  /// Returns the rock after a softening strain [-].
  HoekBrownMass find_mass(double strain) const;

 private:
  SofteningHoekBrown(const LinearElastic& elastic, const Input& in, double factor);

  HoekBrownInput rock_;
  double residual_gsi_;
  SofteningRange range_;
  double dilatancy_ratio_, factor_;
};

}  // namespace talus::material
