// SPDX-License-Identifier: MIT
#pragma once
// Mohr–Coulomb whose c and tan φ fall from peak to residual values with the plastic shear strain, as of stiff clay or
// sensitive soil. mesh.softening_length is the length over which this strain is averaged (theory 23).

#include "material/mohr_coulomb.hpp"
#include "material/point_law.hpp"

namespace talus::material {

/// Strength of soil that softens in methods of limit states.
enum class LimitStrength { peak, residual };

}  // namespace talus::material

namespace talus::input {

template <>
inline constexpr auto choices<material::LimitStrength> = std::array{
    Choice{material::LimitStrength::peak, "peak", "that before any softening: for a first failure at small strain"},
    Choice{material::LimitStrength::residual, "residual", "the softened one: for a slide that has moved before"},
};

}  // namespace talus::input

namespace talus::material {

/// Strain over which a strength falls, and the strength of methods without softening.
struct SofteningRange {
  double softening_start = 0;  ///< ε_q^p at which the strength begins to fall [-]
  double softening_end = 0;    ///< ε_q^p at which it is residual [-]
  LimitStrength limit_strength = LimitStrength::residual;
  bool is_associated = false;  ///< ψ = φ at every strain; set by FEM, not by the case

  /// Returns the share of the softening that a strain has caused, from 0 to 1.
  double find_share(double strain) const {
    return strain <= softening_start ? 0
           : strain >= softening_end ? 1
                                     : (strain - softening_start) / (softening_end - softening_start);
  }
  void check(const SoilFindings& findings) const;
  void add_properties(Properties& list) const;
};
inline void describe(input::Visitor& v, SofteningRange& in, const Users& users) {
  v.key("softening_start", in.softening_start, users.allow(plain().at_least(0)).example("0.01"),
        "Deviatoric plastic strain, ∫√(⅔ ė:ė) dt, at which the strength begins to fall.");
  v.key("softening_end", in.softening_end,
        users.need(plain().above(0)).by_methods({"mpm"}).usual(0.01, 10).example("0.3"),
        "The same strain at which the strength is residual, linearly between.");
  v.key("limit_strength", in.limit_strength,
        users.need(plain()).by_methods({"lem", "fem", "bounds"}).example(R"("residual")"),
        "Strength for LEM and limit analysis, which do not soften, and for FEM where [fem] softening is \"none\".");
}

struct ResidualStrength {
  double residual_cohesion = 0;        ///< [Pa]
  double residual_friction_angle = 0;  ///< [rad]
};
inline void describe(input::Visitor& v, ResidualStrength& in, const Users& users) {
  v.key("residual_cohesion", in.residual_cohesion,
        users.need(quantity("kPa").at_least(0)).usual_or_zero(0.01, 500).example("2"),
        "Cohesion after softening, at most `cohesion`.");
  v.key("residual_friction_angle", in.residual_friction_angle,
        users.need(quantity("deg").at_least(0).below(90)).usual_or_zero(5, 50).example("14"),
        "Friction angle after softening, at most `friction_angle`; tan φ falls linearly, and ψ to zero.");
}

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
