// SPDX-License-Identifier: MIT
// Nodal averages of element values, weighted by element volume (2.94): of the volumetric strain increment, and of the
// plastic return's change of mean stress.

#include "mpm/body/node_average.hpp"
#include "mpm/body/rows.hpp"
#include "mpm/step/kernels.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {
namespace {

/// nodes.smoothed = Σ_e value_e V_e / Σ_e V_e over the elements at each node that take part. `value(block, rows)`
/// gives the values of a block.
template <int D, class Value>
void average_at_nodes(Body<D>& body, int threads, Value&& value) {
  for_blocks(body, threads, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    const Mask active = takes_part(body, first);
    const Pack V_e = select(active, load<Pack>(&body.layout->volumes[first]), Pack(0.0));
    add_average<D>(body.nodes.average, rows, {V_e * select(active, value(b, rows), Pack(0.0)), V_e});
  });
  divide_averages<2, 1>(body, threads, body.nodes.average, body.nodes.smoothed.data());
}

}  // namespace

template <int D>
void smooth_increments(Dry, Body<D>& body, const StepOptions<D>& o) {
  average_at_nodes(body, o.threads, [&](int b, const int* rows) {
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
    return divergence * o.dt;
  });
}

template <int D>
void smooth_plastic_return(Body<D>& body, const StepOptions<D>& o) {
  const Layout<D>& layout = *body.layout;
  average_at_nodes(body, o.threads, [&](int b, const int*) {
    return load<Pack>(&body.elements.plastic_mean[static_cast<std::size_t>(b) * lane_width]);
  });
  for_blocks(body, o.threads, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    const Pack mean = find_node_mean<D, 1>(body.nodes.smoothed.data(), rows);
    const Mask active = takes_part(body, first);
    const Pack change = select(active, mean - load<Pack>(&body.elements.plastic_mean[first]), Pack(0.0));
    store(&body.elements.return_pressure[first], change);
    // the internal force that the changed mean stress makes
    Pack stress[force_size<D>], g[D * D], out[D + 1][1 + 2 * D];
    TALUS_UNROLL
    for (int i = 0; i < force_size<D>; ++i) stress[i] = Pack(0.0);
    const Pack force = change * load<Pack>(&body.elements.force_volume[first]);
    TALUS_UNROLL
    for (int i = 0; i < D; ++i) stress[i] = force;
    TALUS_UNROLL
    for (int i = 0; i < D * D; ++i)
      g[i] = load<Pack>(&layout.gradients[(static_cast<std::size_t>(b) * D * D + i) * lane_width]);
    ElementSums<D, Pack>::force_to_nodes(stress, g, out);
    // the force's columns are the same in both kinds of rows
    TALUS_UNROLL
    for (int k = 0; k <= D; ++k) {
      if (body.water.is_wet())
        add_rows<D, 1 + D, wet_sums_stride<D>>(body.water.sums.data(), rows + k * lane_width, &out[k][1 + D]);
      else
        add_rows<D, 1 + D>(body.nodes.sums.data(), rows + k * lane_width, &out[k][1 + D]);
    }
  });
}

template void smooth_increments<2>(Dry, Body<2>&, const StepOptions<2>&);
template void smooth_increments<3>(Dry, Body<3>&, const StepOptions<3>&);
template void smooth_plastic_return<2>(Body<2>&, const StepOptions<2>&);
template void smooth_plastic_return<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
