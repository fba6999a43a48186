#pragma once
// Mohr–Coulomb with a root cohesion of each point's own: c + c_r, as Wu and Waldron or a fibre bundle give it
// (root_bundle.hpp). Only the cohesion differs from point to point: the code is Mohr–Coulomb's, with other bounds.

#include <array>

#include "material/mohr_coulomb.hpp"

namespace talus::material {

/// State variables: 0 as Mohr–Coulomb's; 1 root cohesion c_r [Pa].
class RootedMohrCoulomb {
 public:
  static constexpr int state_size = 2;
  static constexpr bool is_plastic = true;

  /// `strength` as it acts, reduced already; `root_factor` divides c_r (strength reduction). The tensile strength stays
  /// as given; its limit is the apex (c + c_r)/tanφ.
  RootedMohrCoulomb(const LinearElastic& elastic, const MohrCoulombStrength& strength, double root_factor = 1)
      : soil_(elastic, strength), root_share_(1 / root_factor) {}

  const MohrCoulomb& soil() const { return soil_; }
  double constrained_modulus() const { return soil_.constrained_modulus(); }
  template <int NS>
  double elastic_energy(const double* sigma) const {
    return soil_.elastic_energy<NS>(sigma);
  }
  template <int NS, class T>
  TALUS_KERNEL Response<T> update(T* sigma, const T* d_epsilon, T* state, MaskOf<T> active,
                                  const Surroundings<T>& = {}) const {
    return soil_.update_within<NS>(sigma, d_epsilon, state, active, soil_.widen_bounds<T>(state[1] * root_share_));
  }

  static constexpr std::array<StateField, 1> fields() { return {{{"root_cohesion", "Pa"}}}; }

 private:
  MohrCoulomb soil_;
  double root_share_;
};

}  // namespace talus::material
