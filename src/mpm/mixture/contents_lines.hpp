// SPDX-License-Identifier: MIT
#pragma once
// The water of an element and of a node at the start of a step, for a body B here or on a GPU.

#include <algorithm>
#include <cmath>

#include "mpm/body/body.hpp"
#include "mpm/coupled/kernels.hpp"
#include "mpm/mixture/held_water.hpp"

namespace talus::mpm {

/// Of a node's own water over its share of the elements': where points leave, it goes with them.
inline constexpr double most_own = 0.5;

/// Pores, water and volume of element `e`. Returns whether it is wet.
template <class B>
TALUS_PORTABLE bool sum_element(B& body, int e, bool mixed) {
  constexpr int D = B::dimension, width = B::width;
  using P = PointFields<D>;
  auto& water = body.water;
  auto& m = water.darcy;
  const auto& points = body.points;
  const std::size_t materials = water.laws.size();
  for (std::size_t k = 0; k < materials; ++k) m.pores[k][e] = m.volume[k][e] = 0;
  double content = 0, wet = 0, all = 0, pores = 0, pressure = 0;
  int first = -1;
  bool uniform = true;
  for (int k = 0; k < static_cast<int>(points.count[e]); ++k) {
    const std::int64_t slot = points.block_start[e / width] + k;
    const double* p = points.slot(slot) + e % width;
    const int material = points.material[points.id[static_cast<std::size_t>(slot * width + e % width)]];
    const WaterLaw& law = water.laws[material];
    const double volume = p[P::volume * width];
    all += volume;
    uniform = uniform && (first < 0 || first == material);
    first = material;
    if (!law.wet) continue;
    const double here = find_pores(volume, p[P::mass * width] / law.grain_density);
    const double* w = p + water.first_field * width;
    m.pores[material][e] += here;
    pores += here;
    pressure += here * w[WaterFields<D>::pressure * width];
    m.volume[material][e] += volume;
    content += w[WaterFields<D>::mass * width] / law.density;
    wet += volume;
  }
  m.water[e] = content;
  if (pores > 0) water.mean_pressure[e] = pressure / pores;
  const bool full = mixed && uniform && all > 0 && all > body.elements.fill_limit[e];
  water.stretch[e] = full ? body.mesh().volumes[e] / all : 1.0;
  for (std::size_t k = 0; k < materials; ++k) m.volume[k][e] *= water.stretch[e];
  water.volume[e] = wet;
  return wet > 0;
}

/// Contents of node `i`, and its pressure. In the `first` step a pressure is given, and the node holds what belongs to
/// it.
template <class B>
TALUS_PORTABLE void start_node(B& body, int i, bool first) {
  constexpr int D = B::dimension;
  auto& water = body.water;
  auto& m = water.darcy;
  const auto& graph = *m.graph;
  for (std::size_t k = 0; k < m.node_pores.size(); ++k) m.node_pores[k][i] = 0;
  double content = 0, all = 0, last = 0;
  for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t) {
    const int e = graph.element[t];
    if (!(water.volume[e] > 0)) continue;
    double here = 0;
    for (std::size_t k = 0; k < m.pores.size(); ++k) {
      const double pores = m.pores[k][e] / (D + 1);
      m.node_pores[k][i] += pores;
      here += pores;
    }
    content += m.water[e] / (D + 1);
    last += here * water.mean_pressure[e];
    all += here;
  }
  double& p = m.pressure[i];
  if (!(all > 0)) {
    p = NAN;
    m.node_water[i] = m.own[i] = 0;
    return;
  }
  const HeldWater held(water.laws, m.node_pores, i);
  if (first && !std::isnan(p)) m.own[i] = HeldLine::start(held, p).at(p) - content;
  m.own[i] = std::clamp(m.own[i], -most_own * content, most_own * content);
  content += m.own[i];
  m.node_water[i] = content;
  if (std::isnan(p)) p = last / all;
  if (!held.drains()) return;
  p = p > 0 && content < held.find_full().held ? held.find_suction(content, p) : std::min(p, 0.0);
}

}  // namespace talus::mpm
