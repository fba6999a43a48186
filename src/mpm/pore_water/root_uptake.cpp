// SPDX-License-Identifier: MIT
// Root uptake of water from elements (T16.4), by the same surplus as the exchange between elements.
#include "mpm/pore_water/root_uptake.hpp"

#include "mpm/kernels/root_kernels.hpp"

#include <algorithm>

#include "mpm/state/partition.hpp"

namespace talus::mpm {
namespace {

/// Calls take(e, volume) with the root uptake [m³] of each wet element in `dt` seconds, and adds it to the budget.
/// `water_in(e)`: water of the element [m³].
template <int D, class WaterIn, class Take>
void draw(Body<D>& body, int threads, double dt, WaterIn&& water_in, Take&& take) {
  Water<D>& water = body.water;
  const Layout<D>& layout = *body.layout;
  std::vector<double> rates;
  for (const RootUptake& uptake : water.uptakes) rates.push_back(uptake.rate.at(body.time + 0.5 * dt));
  std::vector<double> drawn(static_cast<std::size_t>(layout.chunks), 0.0);
  for_chunks(body, threads, [&](int c) {
    const int end = std::min(layout.chunk_start[c + 1] * lane_width, body.mesh().element_count());
    for (int e = layout.chunk_start[c] * lane_width; e < end; ++e) {
      const double volume = find_draw(body, water.uptakes, rates, dt, e, [&] { return water_in(e); });
      if (volume == 0) continue;
      take(e, volume);
      drawn[static_cast<std::size_t>(c)] += water.density * volume;
    }
  });
  complete_chunks(body, drawn);
  for (const double mass : drawn) water.transpired += mass;
}

}  // namespace

template <int D>
void draw_root_water(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  if (!o.smooth_pressure && !o.exchange_water) std::fill(water.surplus.begin(), water.surplus.end(), 0.0);
  if (!o.moving) return;
  draw(
      body, o.threads, exchange_interval * o.dt,
      [&](int e) {
        const std::size_t block = static_cast<std::size_t>(e / lane_width) * moment_size<D>;
        return water.moments[block * lane_width + static_cast<std::size_t>(e % lane_width)] / water.density;
      },
      [&](int e, double volume) { water.surplus[e] += volume / water.volume[e]; });
}

template <int D>
void find_root_draw(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  if (water.uptakes.empty()) return;
  DarcyWater<D>& m = water.darcy;
  std::fill(m.drawn.begin(), m.drawn.end(), 0.0);
  if (!o.moving) return;
  draw(
      body, o.threads, o.dt, [&](int e) { return m.water[e]; }, [&](int e, double volume) { m.drawn[e] = volume; });
}

template void find_root_draw<2>(Body<2>&, const StepOptions<2>&);
template void find_root_draw<3>(Body<3>&, const StepOptions<3>&);
template void draw_root_water<2>(Body<2>&, const StepOptions<2>&);
template void draw_root_water<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
