// SPDX-License-Identifier: MIT
// The water of elements and nodes at the start of a step, and the pressures that it starts from.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "mpm/body/node_rows.hpp"
#include "mpm/coupled/kernels.hpp"
#include "mpm/coupled/pore_state.hpp"
#include "mpm/mixture/held_water.hpp"
#include "mpm/mixture/mixture_step.hpp"
#include "mpm/mixture/sweep.hpp"

namespace talus::mpm {
namespace {

/// Of a node's own water over its share of the elements': where points leave, it goes with them.
constexpr double most_own = 0.5;

template <int D>
void allocate(Body<D>& body) {
  MixtureWater<D>& m = body.water.mixture;
  const std::size_t nodes = body.mesh().nodes.size(), materials = body.water.laws.size(),
                    lanes = static_cast<std::size_t>(body.layout->blocks) * lane_width;
  if (!m.graph) m.graph = std::make_shared<const NodeGraph<D>>(make_node_graph(body.mesh()));
  if (m.pressure.size() != nodes) m.pressure.assign(nodes, NAN);
  if (m.ponded.size() != nodes) m.ponded.assign(nodes, 0);
  if (m.change.size() != nodes) m.change.assign(nodes, 0.0);
  m.pore_force.assign(nodes, {});
  if (m.node_water.size() == nodes) return;
  m.pores.assign(materials, AlignedVector<double>(lanes, 0.0));
  m.volume = m.pores;
  m.water.assign(lanes, 0.0);
  for (auto* field : {&m.share, &m.drawn}) field->assign(lanes, 0.0);
  for (auto& component : m.flux) component.assign(lanes, 0.0);
  m.node_pores.assign(materials, std::vector<double>(nodes, 0.0));
  for (auto* field : {&m.node_water, &m.out, &m.passed, &m.mobility}) field->assign(nodes, 0.0);
  m.velocity.assign(nodes, {});
  m.acceleration = m.area = m.velocity;
  for (auto* field : {&m.saturated, &m.effective, &m.coupling, &m.conductive, &m.soft})
    field->assign(body.mesh().elements.size(), 0.0);
}

/// Pores, water and volume of element `e`. Returns whether it is wet.
template <int D>
bool sum_element(Body<D>& body, int e, bool mixed) {
  using P = Points<D>;
  Water<D>& water = body.water;
  MixtureWater<D>& m = water.mixture;
  const P& points = body.points;
  const std::size_t materials = water.laws.size();
  for (std::size_t k = 0; k < materials; ++k) m.pores[k][e] = m.volume[k][e] = 0;
  double content = 0, wet = 0, all = 0, pores = 0, pressure = 0;
  int first = -1;
  bool uniform = true;
  for (int k = 0; k < static_cast<int>(points.count[e]); ++k) {
    const std::int64_t slot = points.block_start[e / lane_width] + k;
    const double* p = points.slot(slot) + e % lane_width;
    const int material = points.material[points.id[static_cast<std::size_t>(slot * lane_width + e % lane_width)]];
    const WaterLaw& law = water.laws[material];
    const double volume = p[P::volume * lane_width];
    all += volume;
    uniform = uniform && (first < 0 || first == material);
    first = material;
    if (!law.wet) continue;
    const double here = find_pores(volume, p[P::mass * lane_width] / law.grain_density);
    const double* w = p + water.first_field * lane_width;
    m.pores[material][e] += here;
    pores += here;
    pressure += here * w[WaterFields<D>::pressure * lane_width];
    m.volume[material][e] += volume;
    content += w[WaterFields<D>::mass * lane_width] / law.density;
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
template <int D>
void start_node(Body<D>& body, int i, bool first) {
  Water<D>& water = body.water;
  MixtureWater<D>& m = water.mixture;
  const NodeGraph<D>& graph = *m.graph;
  for (auto& pores : m.node_pores) pores[i] = 0;
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

}  // namespace

template <int D>
void find_contents(Body<D>& body, const StepOptions<D>& o) {
  allocate(body);
  Water<D>& water = body.water;
  const Layout<D>& layout = *body.layout;
  const int elements = body.mesh().element_count();
  const std::size_t nodes = body.mesh().nodes.size();
  const bool first = water.mixture.own.size() != nodes;  // on all ranks or on none
  if (first) water.mixture.own.assign(nodes, 0.0);
  MixtureWater<D>& m = water.mixture;
  std::vector<std::uint8_t> turned(static_cast<std::size_t>(layout.chunks), 0);
  for_chunks(body, o.threads, [&](int c) {
    const int end = std::min(elements, layout.chunk_start[c + 1] * lane_width);
    for (int e = layout.chunk_start[c] * lane_width; e < end; ++e) {
      const bool was = water.volume[e] > 0;
      if (sum_element(body, e, o.mixed) != was) turned[static_cast<std::size_t>(c)] = 1;
    }
  });
  if (std::any_of(turned.begin(), turned.end(), [](auto t) { return t != 0; })) water.surface_is_stale = true;
  update_elements(body, water.volume, water.mean_pressure, m.water);
  for (auto& pores : m.pores) update_elements(body, pores);
  for_nodes(body, o.threads, [&](int i) { start_node(body, i, first); });
  update_nodes(body, m.pressure);
}

template void find_contents<2>(Body<2>&, const StepOptions<2>&);
template void find_contents<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
