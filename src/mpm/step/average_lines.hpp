// SPDX-License-Identifier: MIT
#pragma once
// What a block gives to the nodal averages of the volumetric strain increment (2.94), for a body B of packs or of one
// thread of a GPU.

#include "base/rows.hpp"
#include "mpm/body/element_average.hpp"
#include "mpm/step/kernels.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {

/// tr Δε of a block.
template <class B, class T = typename B::Lanes>
TALUS_PORTABLE T find_volumetric(const B& body, int b, double dt) {
  constexpr int D = B::dimension, width = B::width;
  const int* rows = &body.layout->connectivity[static_cast<std::size_t>(b) * width * (D + 1)];
  T v[D + 1][2 * D];
  TALUS_UNROLL
  for (int k = 0; k <= D; ++k) load_rows<2 * D, motion_stride<D>>(body.nodes.motion.data(), rows + k * width, v[k]);
  T divergence(0.0);
  const double* g = &body.layout->gradients[static_cast<std::size_t>(b) * D * D * width];
  TALUS_UNROLL
  for (int k = 0; k < D; ++k) {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) divergence += (v[k + 1][D + d] - v[0][D + d]) * load<T>(g + (k * D + d) * width);
  }
  return divergence * dt;
}

/// Value times V_e, and V_e, of the elements of block `b`; zero where they take no part.
template <class B, class T = typename B::Lanes>
TALUS_PORTABLE void find_average_parts(const B& body, int b, const StepOptions<B::dimension>& o, T* parts) {
  const std::size_t first = static_cast<std::size_t>(b) * B::width;
  const MaskOf<T> active = takes_part(body, first);
  const T V_e = select(active, load<T>(&body.layout->volumes[first]), T(0.0));
  T value = find_volumetric(body, b, o.dt);
  if (o.smoothing == input::Smoothing::stable) value -= load<T>(&body.elements.plastic_dilation[first]);
  parts[0] = V_e * select(active, value, T(0.0));
  parts[1] = V_e;
}

}  // namespace talus::mpm
