// SPDX-License-Identifier: MIT
#pragma once
// Mohr–Coulomb whose c and tan φ fall from peak to residual values with the plastic shear strain, as of stiff clay or
// sensitive soil. Over how much soil the strain is averaged, mesh.softening_length says (theory 23).

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

  /// Returns the share of the softening that a strain has caused, from 0 to 1.
  double find_share(double strain) const {
    return strain <= softening_start ? 0
           : strain >= softening_end ? 1
                                     : (strain - softening_start) / (softening_end - softening_start);
  }
  void check(const SoilFindings& findings) const;
  void add_properties(Properties& list) const;
};
void describe(auto& v, SofteningRange& in, const Users& users) {
  v.key("softening_start", in.softening_start, users.allow(plain().at_least(0)).example("0.01"),
        "Deviatoric plastic strain, ∫√(⅔ ė:ė) dt, at which the strength begins to fall.");
  v.key("softening_end", in.softening_end,
        users.need(plain().above(0)).by_methods({"mpm"}).usual(0.01, 10).example("0.3"),
        "The same strain at which the strength is residual, linearly between.");
  v.key("limit_strength", in.limit_strength,
        users.need(plain()).by_methods({"lem", "fem", "bounds"}).example(R"("residual")"),
        "Strength for LEM, FEM and limit analysis, which do not soften.");
}

struct ResidualStrength {
  double residual_cohesion = 0;        ///< [Pa]
  double residual_friction_angle = 0;  ///< [rad]
};
void describe(auto& v, ResidualStrength& in, const Users& users) {
  v.key("residual_cohesion", in.residual_cohesion,
        users.need(quantity("kPa").at_least(0)).usual_or_zero(0.01, 500).example("2"),
        "Cohesion after softening, at most `cohesion`.");
  v.key("residual_friction_angle", in.residual_friction_angle,
        users.need(quantity("deg").at_least(0).below(90)).usual_or_zero(5, 50).example("14"),
        "Friction angle after softening, at most `friction_angle`; tan φ falls linearly, and ψ to zero.");
}

/// State variables: 0 as Mohr–Coulomb's; 1 the strain that softens, which neighbours share over the nonlocal length
/// [-]; 2 gap.
class SofteningMohrCoulomb {
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
          "{}: c and tan φ fall linearly with plastic shear strain in MPM. LEM, FEM and limit analysis take the peak "
          "or "
          "the residual strength of all the soil at once, as `limit_strength` says, and know no progressive failure.",
      .reduction = "In soil that softens the factor divides c and tan φ at every strain."};
  static constexpr int state_size = 3, gap_states = 1;
  static constexpr bool is_plastic = true;

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

  double constrained_modulus(const double* = nullptr, const double* = nullptr) const {
    return peak_.constrained_modulus();
  }
  LinearElastic find_elastic(const double* = nullptr, const double* = nullptr) const { return peak_.elastic(); }
  template <int NS>
  double elastic_energy(const double* sigma, const double* = nullptr) const {
    return peak_.elastic_energy<NS>(sigma);
  }
  static std::vector<StateField> fields() { return {{"softening_strain", "-", 0}, separation_field}; }
  static void show(const double* state, double /*saturation*/, double* values) {
    values[0] = state[1];
    values[1] = state[2];
  }
  static double find_gap(const double* state) { return state[2]; }

  template <int NS, class T>
  Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active,
                     const Surroundings<T>& around = {}) const {
    return update_points<NS, state_size>(
        sigma, d_epsilon, state, active, around,
        [this](double* s, const double* d, double* q, const Surroundings<double>& own) {
          return update_point<NS>(s, d, q, own);
        });
  }

  /// Returns the strength after a softening strain [-].
  MohrCoulombStrength find_strength(double strain) const;

 private:
  SofteningMohrCoulomb(const LinearElastic& elastic, const MohrCoulombStrength& peak,
                       const MohrCoulombStrength& residual, const SofteningRange& range)
      : peak_(elastic, peak), residual_(elastic, residual), range_(range) {}

  /// The strength of a step is that at its start.
  template <int NS>
  Response<double> update_point(double* sigma, const double* d_epsilon, double* state,
                                const Surroundings<double>& around) const {
    if (around.softening) state[1] = std::max(0.0, state[1] + around.softening->nonlocal_correction);
    const double before = state[0];
    Response<double> response{};
    const double share = range_.find_share(state[1]);
    if (share == 0)
      response = update_with<NS>(peak_, sigma, d_epsilon, state, around);
    else if (share == 1)
      response = update_with<NS>(residual_, sigma, d_epsilon, state, around);
    else
      response =
          update_with<NS>(MohrCoulomb(peak_.elastic(), find_strength(state[1])), sigma, d_epsilon, state, around);
    state[1] += state[0] - before;
    if (around.softening) around.softening->softened = state[0] - before;
    return response;
  }
  template <int NS>
  static Response<double> update_with(const MohrCoulomb& soil, double* sigma, const double* d_epsilon, double* state,
                                      const Surroundings<double>& around) {
    return soil.update_within<NS>(sigma, d_epsilon, state, state + 2, true, soil.widen_bounds<double>(0), around);
  }

  MohrCoulomb peak_, residual_;
  SofteningRange range_;
};

}  // namespace talus::material
