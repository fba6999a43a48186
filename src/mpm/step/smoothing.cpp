// SPDX-License-Identifier: MIT
// Nodal averages of the volumetric strain increment of the elements, weighted by their volume (2.94).

#include "mpm/body/node_average.hpp"
#include "mpm/body/rows.hpp"
#include "mpm/step/kernels.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {
namespace {

/// tr Δε of a block.
template <int D>
Pack find_volumetric(const Body<D>& body, int b, const int* rows, double dt) {
  Pack v[D + 1][2 * D];
  TALUS_UNROLL
  for (int k = 0; k <= D; ++k)
    load_rows<2 * D, motion_stride<D>>(body.nodes.motion.data(), rows + k * lane_width, v[k]);
  Pack divergence(0.0);
  const double* g = &body.layout->gradients[static_cast<std::size_t>(b) * D * D * lane_width];
  TALUS_UNROLL
  for (int k = 0; k < D; ++k) {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d)
      divergence += (v[k + 1][D + d] - v[0][D + d]) * load<Pack>(g + (k * D + d) * lane_width);
  }
  return divergence * dt;
}

}  // namespace

// nodes.smoothed = Σ_e value_e V_e / Σ_e V_e over the elements at each node that take part.
template <int D>
void smooth_increments(Dry, Body<D>& body, const StepOptions<D>& o) {
  for_blocks_and_update(body, o.threads, body.nodes.average, 2, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    const Mask active = takes_part(body, first);
    const Pack V_e = select(active, load<Pack>(&body.layout->volumes[first]), Pack(0.0));
    Pack value = find_volumetric(body, b, rows, o.dt);
    if (o.smoothing == input::Smoothing::stable) value -= load<Pack>(&body.elements.plastic_dilation[first]);
    add_average<D>(body.nodes.average, rows, {V_e * select(active, value, Pack(0.0)), V_e});
  });
  divide_averages<2, 1>(body, o.threads, body.nodes.average, body.nodes.smoothed.data());
}

template void smooth_increments<2>(Dry, Body<2>&, const StepOptions<2>&);
template void smooth_increments<3>(Dry, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
