#pragma once
// Isotropic linear elasticity: the predictor of every other model.

#include "material/surroundings.hpp"

namespace talus::material {

/// Number of stress components: xx yy zz xy (plane strain), and yz zx in three dimensions. Shear strains are
/// engineering strains (2ε_xy), stresses positive in tension.
template <int D>
inline constexpr int stress_size = D == 2 ? 4 : 6;

/// What an update tells beside the new stress. All per point.
template <class T>
struct Response {
  bool any_plastic;       ///< false: no lane yielded, the state is as before and the rest is zero
  T plastic_mean_stress;  ///< change of the mean stress by the plastic return [Pa]
  T dissipation;          ///< plastic work σ:Δε^p [J/m³]
};

struct LinearElastic {
  static constexpr int state_size = 0;
  static constexpr bool is_plastic = false;

  double lambda = 0;  ///< Lamé's λ [Pa]
  double mu = 0;      ///< shear modulus [Pa]

  static LinearElastic from_young(double young_modulus, double poisson_ratio) {
    return {young_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)),
            young_modulus / (2 * (1 + poisson_ratio))};
  }

  /// Adds C:Δε to the stress. `d_epsilon` has NS components.
  template <int NS, class T>
  TALUS_KERNEL void add_elastic_increment(T* sigma, const T* d_epsilon) const {
    const T volumetric = (d_epsilon[0] + d_epsilon[1] + d_epsilon[2]) * lambda;
    TALUS_UNROLL
    for (int i = 0; i < 3; ++i) sigma[i] += volumetric + d_epsilon[i] * (2 * mu);
    TALUS_UNROLL
    for (int i = 3; i < NS; ++i) sigma[i] += d_epsilon[i] * mu;
  }

  template <int NS, class T>
  TALUS_KERNEL Response<T> update(T* sigma, const T* d_epsilon, T* /*state*/, MaskOf<T> /*active*/,
                                  const Surroundings<T>& = {}) const {
    add_elastic_increment<NS>(sigma, d_epsilon);
    return {false, T(0.0), T(0.0)};
  }

  /// E_c = λ + 2μ of (2.84) [Pa].
  double constrained_modulus() const { return lambda + 2 * mu; }

  /// Elastic energy density ½ σ:C⁻¹:σ [J/m³].
  template <int NS>
  double elastic_energy(const double* sigma) const {
    const double trace = sigma[0] + sigma[1] + sigma[2];
    double squares = sigma[0] * sigma[0] + sigma[1] * sigma[1] + sigma[2] * sigma[2];
    for (int i = 3; i < NS; ++i) squares += 2 * sigma[i] * sigma[i];
    return (squares - lambda / (3 * lambda + 2 * mu) * trace * trace) / (4 * mu);
  }
};

}  // namespace talus::material
