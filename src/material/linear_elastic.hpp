// SPDX-License-Identifier: MIT
#pragma once
// Isotropic linear elasticity: the predictor of every other model.

#include "material/blocks.hpp"
#include "material/properties.hpp"
#include "material/surroundings.hpp"

namespace talus::material {

using input::plain;
using input::quantity;

/// Number of stress components: xx yy zz xy (plane strain), and yz zx in three dimensions. Shear strains are
/// engineering strains (2ε_xy), stresses positive in tension.
template <int D>
inline constexpr int stress_size = D == 2 ? 4 : 6;

/// What an update tells beside the new stress. All per point.
template <class T>
struct Response {
  bool any_plastic;    ///< false: no lane yielded, the state is as before and the rest is zero
  T plastic_dilation;  ///< Δε^p of the step, summed over the directions that move: two of NS = 4, all of 6 [-]
  /// Plastic work of the step [J/m³]. Mohr–Coulomb's is that of the mean of the stresses before and after,
  /// ½(σ_old + σ):Δε^p, which is what the elastic energy and the work of a finite step leave.
  T dissipation;
  // Of soil that comes apart, separation.hpp.
  T opened{0.0};  ///< growth of its gaps, below zero where they closed [-]
  T gap{0.0};     ///< at the end of the step [-]
};

struct YoungInput {
  double young_modulus = 0;  ///< E [Pa]
};
template <class Visitor>
void describe(Visitor& v, YoungInput& in, const Users& users) {
  const std::vector<input::Slip> slips{{"MPa", 1e3}, {"GPa", 1e6}, {"Pa", 1e-3}, {"psf", 0.0478803}};
  v.key("young_modulus", in.young_modulus,
        users.need(quantity("kPa").above(0)).by_methods({"fem", "mpm"}).usual(200, 5e6, slips).example("45000"),
        "Young's modulus.");
}

struct PoissonInput {
  double poisson_ratio = 0;  ///< ν [-]
};
template <class Visitor>
void describe(Visitor& v, PoissonInput& in, const Users& users) {
  v.key("poisson_ratio", in.poisson_ratio,
        users.need(plain().above(-1).below(0.5)).by_methods({"fem", "mpm"}).usual_or_zero(0.05, 0.495).example("0.3"),
        "Poisson's ratio.");
}

struct LinearElastic {
  static constexpr Traits traits{.word = "linear_elastic",
                                 .meaning = "linear elastic, without any strength limit",
                                 .title = "linear elastic",
                                 .strength = Strength::none,
                                 .serves_slices = true,
                                 .paragraphs = {"linear_elastic"}};
  static constexpr int state_size = 0;
  static constexpr bool is_plastic = false;

  using Input = Needs<YoungInput, PoissonInput>;
  static LinearElastic make(const Input& in, const StrengthChange& = {}) {
    return from_young(in.get<YoungInput>().young_modulus, in.get<PoissonInput>().poisson_ratio);
  }

  double lambda = 0;  ///< Lamé's λ [Pa]
  double mu = 0;      ///< shear modulus [Pa]

  static LinearElastic from_young(double young_modulus, double poisson_ratio) {
    return {young_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)),
            young_modulus / (2 * (1 + poisson_ratio))};
  }

  static LinearElastic from_constrained_modulus(double modulus, double poisson_ratio) {
    const LinearElastic unit = from_young(1, poisson_ratio);
    const double ratio = modulus / unit.constrained_modulus();
    return {unit.lambda * ratio, unit.mu * ratio};
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
  TALUS_PORTABLE double constrained_modulus(const double* = nullptr, const double* = nullptr) const {
    return lambda + 2 * mu;
  }
  /// The elastic stiffness at a stress and state.
  LinearElastic find_elastic(const double* = nullptr, const double* = nullptr) const { return *this; }

  /// Elastic energy density ½ σ:C⁻¹:σ [J/m³].
  template <int NS>
  TALUS_PORTABLE double elastic_energy(const double* sigma, const double* = nullptr) const {
    const double trace = sigma[0] + sigma[1] + sigma[2];
    double squares = sigma[0] * sigma[0] + sigma[1] * sigma[1] + sigma[2] * sigma[2];
    for (int i = 3; i < NS; ++i) squares += 2 * sigma[i] * sigma[i];
    return (squares - lambda / (3 * lambda + 2 * mu) * trace * trace) / (4 * mu);
  }
};

}  // namespace talus::material
