// SPDX-License-Identifier: MIT
#pragma once
// Isotropic linear elasticity: the predictor of every other model.

#include "material/blocks.hpp"
#include "material/properties.hpp"

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

// Soil that comes apart. Where a soil bears no more tension in any direction that moves, its volume grows as if it
// flowed. What grows there is a gap. The gap is kept as a volume strain, and when the soil is pressed again the gap
// closes first: only then stress returns (after Tampubolon et al. 2017, ACM Trans. Graph. 36, 105). Without it loose
// soil gains volume for ever, and gains energy whenever it is pressed.

inline const StateField separation_field{"separation", "-", 0};

/// What is left of a strain increment when gaps have closed.
template <int NS, class T>
struct AfterClosing {
  T strain[NS];
  T closed{0.0};  ///< how far gaps closed [-]
  T work{0.0};    ///< done by a compressive stress on it: dissipated [J/m³]

  /// Pressing soil first takes its tension away, elastically, and then closes the `gap`. The closing is spread over the
  /// directions that move. An element shares the state of its points, so it may have a gap and a compressive stress.
  TALUS_KERNEL AfterClosing(const LinearElastic& elastic, const T* sigma, const T* d_epsilon, T gap, MaskOf<T> active) {
    constexpr int D = NS == 4 ? 2 : 3;
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) strain[i] = d_epsilon[i];
    const T zero(0.0);
    const double stiffness = elastic.lambda + 2 * elastic.mu / D;  // mean stress of these directions per volume strain
    T mean = sigma[0] + sigma[1], volumetric = d_epsilon[0] + d_epsilon[1];
    if constexpr (D == 3) {
      mean += sigma[2];
      volumetric += d_epsilon[2];
    }
    mean *= 1.0 / D;
    const T pressed = -volumetric - lane_max(mean, zero) * (1.0 / stiffness);
    closed = select(active, lane_max(zero, lane_min(gap, pressed)), zero);
    work = lane_max(-mean, zero) * closed;
    TALUS_UNROLL
    for (int i = 0; i < D; ++i) strain[i] += closed * (1.0 / D);
  }
  /// Puts the closing into the response of the soil to the rest of the strain, and changes the gap.
  TALUS_KERNEL void finish(Response<T>& response, T* gap, MaskOf<T> active) const {
    response.opened -= closed;
    if (any(active && closed > T(0.0))) {
      response.any_plastic = true;
      response.dissipation += work;
    }
    if (response.any_plastic) *gap += select(active, response.opened, T(0.0));
    response.gap = *gap;
  }
};

}  // namespace talus::material
