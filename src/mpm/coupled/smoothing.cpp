// SPDX-License-Identifier: MIT
// Nodal averages of what makes soil and water change their volume: of the strain increment with weights V_e, of the
// divergence of the seepage with weights V̄ (2.94), and the surplus of pressure smoothing (2.96, T14.8).

#include "base/rows.hpp"
#include "mpm/body/node_average.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/kernels.hpp"

namespace talus::mpm {
namespace {

constexpr int columns = 4;  ///< of a row of Water::average: value and weight, twice

/// Strain increment and divergence of a block, times Δt.
template <int D>
std::pair<Pack, Pack> find_increments(const Body<D>& body, int b, const int* rows, double dt) {
  Pack strain(0.0), divergence(0.0), first[4 * D];
  const double* g = &body.layout->gradients[static_cast<std::size_t>(b) * D * D * lane_width];
  load_rows<4 * D, wet_motion_stride<D>>(body.water.motion.data(), rows, first);
  TALUS_UNROLL
  for (int k = 0; k < D; ++k) {
    Pack motion[4 * D];
    load_rows<4 * D, wet_motion_stride<D>>(body.water.motion.data(), rows + (k + 1) * lane_width, motion);
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      const Pack gradient = load<Pack>(g + (k * D + d) * lane_width);
      strain += (motion[2 * D + d] - first[2 * D + d]) * gradient;
      divergence += (motion[3 * D + d] - first[3 * D + d]) * gradient;
    }
  }
  return {strain * dt, divergence * dt};
}

}  // namespace

template <int D>
void smooth_increments(Wet, Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  const bool strains = o.smoothing != input::Smoothing::none, stable = o.smoothing == input::Smoothing::stable;
  if (strains) {
    for_blocks_and_update(body, o.threads, water.average, columns, [&](int b, const int* rows) {
      const std::size_t first = static_cast<std::size_t>(b) * lane_width;
      const Mask active = load<Pack>(&body.points.count[first]) > Pack(0.0);
      const Pack V_e = select(takes_part(body, first), load<Pack>(&body.layout->volumes[first]), Pack(0.0));
      const Pack wet = select(active, load<Pack>(&water.volume[first]) * load<Pack>(&water.stretch[first]), Pack(0.0));
      auto [strain, divergence] = find_increments(body, b, rows, o.dt);
      if (stable) strain -= load<Pack>(&body.elements.plastic_dilation[first]);
      add_average<D>(water.average, rows,
                     {V_e * select(active, strain, Pack(0.0)), V_e, wet * select(active, divergence, Pack(0.0)), wet});
    });
    divide_averages<columns, columns>(body, o.threads, water.average, water.smoothed.data());
  }
  if (!o.smooth_pressure) return;
  // What makes the pressure of an element rise, per volume; kept in `surplus` until its average is known.
  for_blocks(body, o.threads, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    auto [strain, divergence] = find_increments(body, b, rows, o.dt);
    if (strains) {
      Pack smooth = find_node_mean<Body<D>, columns>(water.smoothed.data(), rows), rough;
      if (stable) smooth = join_dilation(body, first, strain, smooth, rough);
      strain = select(is_apart(body, first), strain, smooth);
      divergence = find_node_mean<Body<D>, columns>(water.smoothed.data() + 1, rows);
    }
    store(&water.surplus[first],
          load<Pack>(&water.stretch[first]) * (load<Pack>(&water.mean_saturation[first]) * strain + divergence));
  });
  for_blocks_and_update(body, o.threads, water.average, columns, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    const Mask active = load<Pack>(&body.points.count[first]) > Pack(0.0);
    const Pack volume = select(active, load<Pack>(&water.volume[first]), Pack(0.0));
    const Pack value = select(active, load<Pack>(&water.surplus[first]), Pack(0.0));
    add_average<D>(water.average, rows, {Pack(0.0), Pack(0.0), volume * value, volume});
  });
  divide_averages<columns, columns>(body, o.threads, water.average, water.smoothed.data() + 2);
  for_blocks(body, o.threads, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    store(&water.surplus[first],
          find_node_mean<Body<D>, columns>(water.smoothed.data() + 3, rows) - load<Pack>(&water.surplus[first]));
  });
}

template void smooth_increments<2>(Wet, Body<2>&, const StepOptions<2>&);
template void smooth_increments<3>(Wet, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
