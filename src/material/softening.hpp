// SPDX-License-Identifier: MIT
#pragma once
// Mohr–Coulomb whose c and tan φ fall from peak to residual values with the plastic shear strain, as of stiff clay or
// sensitive soil. mesh.softening_length is the length over which this strain is averaged (theory 23).

#include "material/mohr_coulomb.hpp"
#include "material/point_law.hpp"

namespace talus::material {

/// Base of laws that soften. `L` is the law, with update_softened<NS>(strain, sigma, d_epsilon, state, around) for the
/// strength after a softening strain, whose state is Mohr–Coulomb's. State variables: 0 as Mohr–Coulomb's; 1 the strain
/// that softens, which neighbours share over the nonlocal length [-]; 2 gap.
template <class L>
struct SofteningLaw : PointLaw<L> {
  using PointLaw<L>::PointLaw;
  static constexpr int state_size = 3, gap_states = 1, softening_state = 1;
  static constexpr bool is_plastic = true;

  static std::vector<StateField> fields() { return {{"softening_strain", "-", 0}, separation_field}; }
  static void show(const double* state, double /*saturation*/, double* values) {
    values[0] = state[1];
    values[1] = state[2];
  }
  static double find_gap(const double* state) { return state[2]; }

  /// The strength of a step is that at its start.
  template <int NS>
  Response<double> update_point(double* sigma, const double* d_epsilon, double* state,
                                const Surroundings<double>& around) const {
    if (around.softening) state[1] = std::max(0.0, state[1] + around.softening->nonlocal_correction);
    double own[]{state[0], state[2]};
    const Response<double> response =
        static_cast<const L&>(*this).template update_softened<NS>(state[1], sigma, d_epsilon, own, around);
    const double strain = own[0] - state[0];
    state[0] = own[0], state[1] += strain, state[2] = own[1];
    if (around.softening) around.softening->softened = strain;
    return response;
  }
};

class SofteningMohrCoulomb : public SofteningLaw<SofteningMohrCoulomb> {
 public:
  static constexpr Traits traits{
      .word = "softening_mohr_coulomb",
      .meaning = "Mohr–Coulomb's strength that falls from a peak to a residual value with plastic shear strain",
      .title = "Mohr–Coulomb with softening",
      .serves_slices = true,
      .has_friction = true,
      .softens = true,
      .is_opaque = true,
      .paragraphs = {"mohr_coulomb", "softening"},
      .assumption =
          "{}: c and tan φ fall linearly with plastic shear strain in MPM, and in FEM with [fem] softening = "
          "\"progressive\". Otherwise FEM, LEM and limit analysis use the peak or the residual strength of "
          "`limit_strength` everywhere, without progressive failure.",
      .reduction = "In soil that softens the factor divides c and tan φ at every strain."};
  using Input = Needs<YoungInput, PoissonInput, MohrCoulombStrength, ResidualStrength, SofteningRange>;
  static SofteningMohrCoulomb make(const Input& in, const StrengthChange& change);
  static void check(const Input& in, const SoilFindings& findings);
  static Properties list_properties(const Input& in);
  static SliceStrength find_slice_strength(const Input& in);
  /// The law of methods without softening, and the strength that it takes.
  using Limit = MohrCoulomb;
  static void stop_softening(const Input::Changeable& in);
  static void divide(const Input::Changeable& in, PartialDivision& division);
  static bool is_total_stress(const Input& in) { return in.get<MohrCoulombStrength>().friction_angle == 0; }

  template <int NS>
  Response<double> update_softened(double strain, double* sigma, const double* d_epsilon, double* state,
                                   const Surroundings<double>& around) const {
    const double share = range_.find_share(strain);
    if (share == 0) return peak_.update<NS>(sigma, d_epsilon, state, true, around);
    if (share == 1) return residual_.update<NS>(sigma, d_epsilon, state, true, around);
    return MohrCoulomb(*this, find_strength(strain)).update<NS>(sigma, d_epsilon, state, true, around);
  }
  /// Returns the perfectly plastic law with the strength after a softening strain [-].
  MohrCoulomb make_frozen(double strain) const {
    const double share = range_.find_share(strain);
    if (share == 0) return peak_;
    if (share == 1) return residual_;
    return MohrCoulomb(*this, find_strength(strain));
  }
  const SofteningRange& range() const { return range_; }
  /// Returns the strength after a softening strain [-].
  MohrCoulombStrength find_strength(double strain) const;

 private:
  SofteningMohrCoulomb(const LinearElastic& elastic, const MohrCoulombStrength& peak,
                       const MohrCoulombStrength& residual, const SofteningRange& range)
      : SofteningLaw(elastic), peak_(elastic, peak), residual_(elastic, residual), range_(range) {}

  MohrCoulomb peak_, residual_;
  SofteningRange range_;
};

}  // namespace talus::material
