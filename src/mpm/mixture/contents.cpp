// SPDX-License-Identifier: MIT
// The water of elements and nodes at the start of a step, and the pressures that it starts from.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "mpm/body/node_rows.hpp"
#include "mpm/mixture/contents_lines.hpp"
#include "mpm/mixture/mixture_step.hpp"
#include "mpm/mixture/sweep.hpp"

namespace talus::mpm {
namespace {

template <int D>
void allocate(Body<D>& body) {
  DarcyWater<D>& m = body.water.darcy;
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

}  // namespace

template <int D>
void find_contents(Body<D>& body, const StepOptions<D>& o) {
  allocate(body);
  Water<D>& water = body.water;
  const Layout<D>& layout = *body.layout;
  const int elements = body.mesh().element_count();
  const std::size_t nodes = body.mesh().nodes.size();
  const bool first = water.darcy.own.size() != nodes;  // on all ranks or on none
  if (first) water.darcy.own.assign(nodes, 0.0);
  DarcyWater<D>& m = water.darcy;
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
