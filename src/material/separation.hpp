// SPDX-License-Identifier: MIT
#pragma once
// Soil that comes apart. Where a soil bears no more tension in any direction that moves, its volume grows as if it
// flowed. What grows there is a gap. The gap is kept as a volume strain, and when the soil is pressed again the gap
// closes first: only then stress returns (after Tampubolon et al. 2017, ACM Trans. Graph. 36, 105). Without it loose
// soil gains volume for ever, and gains energy whenever it is pressed.

#include "material/linear_elastic.hpp"
#include "material/surroundings.hpp"

namespace talus::material {

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
