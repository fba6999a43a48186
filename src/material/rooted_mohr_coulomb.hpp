// SPDX-License-Identifier: MIT
#pragma once
// Mohr–Coulomb with a root cohesion c_r at each point, added to c, and the models that give c_r: Wu and Waldron's sum
// and the fibre bundle. The code is that of Mohr–Coulomb with bounds per point.

#include <vector>

#include "material/mohr_coulomb.hpp"

namespace talus::material {

// Root cohesion of a shear plane that roots cross. Symbols and sources: docs/theory/17-root-cohesion.md.

/// Roots of one diameter that cross a shear plane.
struct RootClass {
  double diameter = 0;    ///< d [m]
  double area_ratio = 0;  ///< a, root area ratio: cross-section of these roots over that of the soil [-]
  double strength = 0;    ///< T, tensile strength [Pa]
};

/// Returns c_r = k' Σ T_i a_i (T17.2): all roots break at once. `orientation` is k' [-].
double find_wu_waldron_cohesion(const std::vector<RootClass>& roots, double orientation);

/// Returns c_r = k' max_j F_j Σ_{i not weaker than j} n_i (T17.4), F = T π d²/4 and n = a/(π d²/4): intact roots carry
/// equal loads, and the weakest root breaks first. The value never exceeds Wu and Waldron's.
double find_fibre_bundle_cohesion(std::vector<RootClass> roots, double orientation);

/// State variables: 0 as for Mohr–Coulomb; 1 root cohesion c_r plus the increase of c with depth [Pa]; 2 gap
/// (linear_elastic.hpp).
class RootedMohrCoulomb {
 public:
  static constexpr Traits traits{.word = "rooted_mohr_coulomb",
                                 .meaning = "the same with the cohesion of roots added",
                                 .title = "Mohr–Coulomb with the cohesion of roots",
                                 .serves_slices = true,
                                 .has_friction = true,
                                 .roots = RootEffect::cohesion,
                                 .paragraphs = {"mohr_coulomb", "root_cohesion"}};
  static constexpr int state_size = 3, gap_states = 1;
  static constexpr bool is_plastic = true;

  using Input = Needs<YoungInput, PoissonInput, MohrCoulombStrength, CohesionGradient, RootCohesionInput>;
  static RootedMohrCoulomb make(const Input& in, const StrengthChange& change) {
    return {LinearElastic::make(in), in.get<MohrCoulombStrength>().changed(change), change.factor};
  }
  static void check(const Input& in, const SoilFindings& findings) { MohrCoulomb::check(in, findings); }
  static Properties list_properties(const Input& in) { return MohrCoulomb::list_properties(in); }
  static SliceStrength find_slice_strength(const Input& in) { return MohrCoulomb::find_slice_strength(in); }
  static void divide(const Input::Changeable& in, PartialDivision& division) {
    MohrCoulomb::divide(MohrCoulomb::Input::Changeable(in), division);
    division.divide(in.get<RootCohesionInput>().root_cohesion, division.cohesion, "cohesion of roots", "c_r", "kPa",
                    1e3);
  }
  static bool is_total_stress(const Input& in) { return MohrCoulomb::is_total_stress(in); }
  using Local = RootedMohrCoulomb;
  static bool varies(const Input&) { return true; }
  void set_initial_state(const Input& in, const StateStart& start, double* state) const {
    state[1] = start.strength_growth.value_or(in.get<CohesionGradient>().find_extra(start.level) + start.root_cohesion);
  }

  /// `strength` is already reduced; `root_factor` divides c_r (strength reduction). The tensile strength is unchanged;
  /// its limit is the apex (c + c_r)/tanφ.
  RootedMohrCoulomb(const LinearElastic& elastic, const MohrCoulombStrength& strength, double root_factor = 1)
      : soil_(elastic, strength), root_share_(1 / root_factor) {}

  const MohrCoulomb& soil() const { return soil_; }
  TALUS_PORTABLE double constrained_modulus(const double* = nullptr, const double* = nullptr) const {
    return soil_.constrained_modulus();
  }
  LinearElastic find_elastic(const double* = nullptr, const double* = nullptr) const { return soil_.elastic(); }
  template <int NS>
  TALUS_PORTABLE double elastic_energy(const double* sigma, const double* = nullptr) const {
    return soil_.elastic_energy<NS>(sigma);
  }
  template <int NS, class T>
  TALUS_KERNEL Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active,
                                  const Surroundings<T>& around = {}) const {
    return soil_.update_within<NS>(sigma, d_epsilon, state, state + 2, active,
                                   soil_.widen_bounds<T>(state[1] * root_share_), around);
  }

  static void read_start(const double* state, StateStart& start) { start.strength_growth = state[1]; }
  static std::vector<StateField> fields() { return {{"root_cohesion", "Pa", 0}, separation_field}; }
  static void show(const double* state, double /*saturation*/, double* values) {
    values[0] = state[1];
    values[1] = state[2];
  }
  TALUS_PORTABLE static double find_gap(const double* state) { return state[2]; }

 private:
  MohrCoulomb soil_;
  double root_share_;
};

}  // namespace talus::material
