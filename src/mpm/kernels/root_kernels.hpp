// SPDX-License-Identifier: MIT
#pragma once
// Root uptake of an element (T16.4), for a body B here or on a GPU.

#include <algorithm>

#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Largest fraction of an element's water that one uptake removes, whatever the rate.
inline constexpr double most_drawn = 0.05;

/// Sum of the uptake weights of the points of element `e` [m²] (2D: m).
template <class B, class Uptake>
TALUS_PORTABLE double sum_weights(const B& body, const Uptake& uptake, int e) {
  constexpr int width = B::width;
  const auto& points = body.points;
  const int b = e / width, lane = e % width, count = static_cast<int>(points.count[e]);
  double sum = 0;
  for (int k = 0; k < count; ++k)
    sum += uptake.weight[static_cast<std::size_t>(
        points.id[static_cast<std::size_t>((points.block_start[b] + k) * width + lane)])];
  return sum;
}

/// Root uptake [m³] of element `e` in `dt` seconds. `rates`: of the uptakes [m/s]; water_in(): water of the element
/// [m³].
template <class B, class Uptakes, class Rates, class WaterIn>
TALUS_PORTABLE double find_draw(const B& body, const Uptakes& uptakes, const Rates& rates, double dt, int e,
                                const WaterIn& water_in) {
  if (body.points.count[e] == 0 || !(body.water.volume[e] > 0)) return 0;
  double volume = 0;
  for (std::size_t q = 0; q < rates.size(); ++q) {
    if (rates[q] == 0) continue;
    const double share = uptakes[q].reduction.evaluate(body.water.mean_pressure[e]).value;
    if (share > 0) volume += share * rates[q] * dt * sum_weights(body, uptakes[q], e);
  }
  return volume == 0 ? 0 : std::min(volume, most_drawn * water_in());
}

}  // namespace talus::mpm
