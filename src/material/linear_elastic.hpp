// SPDX-License-Identifier: MIT
#pragma once
// Isotropic linear elasticity, the predictor of every other law, and the gaps of soil that separates in tension.

#include "base/lane.hpp"
#include "material/inputs.hpp"
#include "material/law.hpp"

namespace talus::material {

using input::plain;
using input::quantity;

/// Output of an update beside the new stress, per point.
template <class T>
struct Response {
  bool any_plastic;    ///< false: no lane yielded, the state is unchanged and the rest is zero
  T plastic_dilation;  ///< Δε^p of the step, sum over two directions for NS = 4, three for NS = 6 [-]
  /// Plastic work of the step [J/m³]. Mohr–Coulomb uses the mean of the stresses before and after, ½(σ_old + σ):Δε^p,
  /// which closes the balance of elastic energy and work over a finite step.
  T dissipation;
  // Output of separating soil:
  T opened{0.0};  ///< increase of the gap, negative where it closed [-]
  T gap{0.0};     ///< gap at the end of the step [-]
};

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

  /// Returns E_c = λ + 2μ of (2.84) [Pa].
  TALUS_PORTABLE double constrained_modulus(const double* = nullptr, const double* = nullptr) const {
    return lambda + 2 * mu;
  }
  /// Returns the elastic stiffness at a stress and state.
  LinearElastic find_elastic(const double* = nullptr, const double* = nullptr) const { return *this; }

  /// Returns the elastic energy density ½ σ:C⁻¹:σ [J/m³].
  template <int NS>
  TALUS_PORTABLE double elastic_energy(const double* sigma, const double* = nullptr) const {
    const double trace = sigma[0] + sigma[1] + sigma[2];
    double squares = sigma[0] * sigma[0] + sigma[1] * sigma[1] + sigma[2] * sigma[2];
    for (int i = 3; i < NS; ++i) squares += 2 * sigma[i] * sigma[i];
    return (squares - lambda / (3 * lambda + 2 * mu) * trace * trace) / (4 * mu);
  }
};

// Separation. Where the soil is at its tension limit in all D directions, plastic flow increases its volume; this
// increase is a gap, stored as a volumetric strain. In later compression the gap closes first, and only then
// compressive stress returns (after Tampubolon et al. 2017, ACM Trans. Graph. 36, 105). Without gaps, loose soil gains
// volume in every cycle, and gains energy in every compression.

inline const StateField separation_field{"separation", "-", 0};

/// Strain increment that remains after gaps have closed.
template <int NS, class T>
struct AfterClosing {
  T strain[NS];
  T closed{0.0};  ///< decrease of the gap [-]
  T work{0.0};    ///< work of a compressive stress on the closing, dissipated [J/m³]

  /// Compression first removes the tension elastically, then closes the `gap`. The closing is spread equally over the D
  /// directions. Points of an element share its state, so a gap and a compressive stress may occur together.
  TALUS_KERNEL AfterClosing(const LinearElastic& elastic, const T* sigma, const T* d_epsilon, T gap, MaskOf<T> active) {
    constexpr int D = NS == 4 ? 2 : 3;
    TALUS_UNROLL
    for (int i = 0; i < NS; ++i) strain[i] = d_epsilon[i];
    const T zero(0.0);
    const double stiffness =
        elastic.lambda + 2 * elastic.mu / D;  // mean stress of the D directions over volumetric strain
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
  /// Adds the closing to the response to the remaining strain and updates the gap.
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
