// SPDX-License-Identifier: MIT
// States between stages: birth and death of elements, and what the pore water bears.

#include <algorithm>
#include <cmath>

#include "fem/consolidation/coupled_system.hpp"
#include "fem/solid/softening.hpp"
#include "material/every_law.hpp"

namespace talus::fem {
namespace {

/// Starts the joints of walls with the stress of the soil beside them, so that a wall in soil that stays is placed
/// without a change of stress; beside placed soil there is none.
template <int D>
void start_joints(const SolidSystem<D>& system, SolidState<D>& out) {
  constexpr std::size_t points = Quadratic<D>::points;
  const std::size_t first = system.springs.list.size();
  for (std::size_t s = 0; s < system.springs.joints.size(); ++s) {
    const Joint& joint = system.springs.joints[s];
    if (joint.is_section) continue;
    std::array<double, 3> stress{};  // xx, yy, xy
    for (std::size_t q = 0; q < points; ++q) {
      const auto& at = out.stress[static_cast<std::size_t>(joint.element) * points + q];
      for (std::size_t i = 0; i < 3; ++i) stress[i] += at[i < 2 ? i : 3] / static_cast<double>(points);
    }
    const Vec<2>& n = joint.normal;
    const Vec<2> along = joint.side == 0 ? Vec<2>{n[1], -n[0]} : Vec<2>{-n[1], n[0]};
    const Vec<2> traction{stress[0] * n[0] + stress[2] * n[1], stress[2] * n[0] + stress[1] * n[1]};
    out.bars[first + 2 * s] = std::min(0.0, dot(traction, n)) / joint.normal_stiffness;
    out.bars[first + 2 * s + 1] = dot(traction, along) / joint.tangential_stiffness;
  }
}

/// Deformations of the springs of each bar and wall, which the supports of both stages share.
template <int D>
void carry_bars(const SolidSystem<D>& old_system, const SolidState<D>& state, const SolidSystem<D>& system,
                SolidState<D>& out) {
  const auto find_bar = [&](int bar) -> int {
    const auto& now = system.model.bars;
    const auto& then = old_system.model.bars;
    if (bar >= static_cast<int>(now.size())) {  // a wall
      const Wall& wall = system.model.walls[static_cast<std::size_t>(bar) - now.size()];
      for (std::size_t w = 0; w < old_system.model.walls.size(); ++w)
        if (old_system.model.walls[w].name == wall.name && old_system.model.walls[w].nodes == wall.nodes)
          return static_cast<int>(then.size() + w);
      return -1;
    }
    const Bar& one = now[static_cast<std::size_t>(bar)];
    for (std::size_t b = 0; b < then.size(); ++b)
      if (then[b].name == one.name && then[b].head == one.head && then[b].end == one.end) return static_cast<int>(b);
    return -1;
  };
  const auto& list = system.springs.list;
  const auto& old_list = old_system.springs.list;
  for (std::size_t s = 0; s < list.size(); ++s) {
    const int bar = find_bar(list[s].bar);
    if (bar < 0) continue;
    for (std::size_t o = 0; o < old_list.size(); ++o)
      if (old_list[o].bar == bar && old_list[o].kind == list[s].kind &&
          std::abs(old_list[o].place - list[s].place) < 1e-9)
        out.bars[s] = state.bars[o];
  }
  const auto& joints = system.springs.joints;
  const auto& old_joints = old_system.springs.joints;
  for (std::size_t s = 0; s < joints.size(); ++s) {
    const int wall = find_bar(static_cast<int>(system.model.bars.size()) + joints[s].wall);
    if (wall < 0) continue;
    for (std::size_t o = 0; o < old_joints.size(); ++o)
      if (old_joints[o].wall == wall - static_cast<int>(old_system.model.bars.size()) &&
          old_joints[o].is_section == joints[s].is_section && old_joints[o].side == joints[s].side &&
          std::abs(old_joints[o].place - joints[s].place) < 1e-9)
        for (std::size_t i = 0; i < 2; ++i) out.bars[list.size() + 2 * s + i] = state.bars[old_list.size() + 2 * o + i];
  }
}

template <int D>
double find_acting(const ConsolidationModel<D>& model, int region, double s) {
  if (s <= 0) return s;
  if (model.suction_stress) return model.suction_stress(region, s).value;
  return s * material::saturation(model.flow->soils[static_cast<std::size_t>(region)].retention, s);
}

}  // namespace

template <int D>
std::vector<std::array<double, D + 1>> find_corner_stress(const ConsolidationModel<D>& model,
                                                          const std::vector<double>& head) {
  const auto& mesh = *model.flow->mesh;
  std::vector<std::array<double, D + 1>> stress = model.solid->pore_stress;
  stress.resize(mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const int region = mesh.element_region[e];
    if (region == mesh::empty_region) continue;
    for (std::size_t a = 0; a <= D; ++a) {
      const auto node = static_cast<std::size_t>(mesh.elements[e][a]);
      const double level = mesh.nodes[node][static_cast<std::size_t>(model.flow->up)];
      stress[e][a] += find_acting(model, region, model.flow->unit_weight * (level - head[node]));
    }
  }
  return stress;
}

template <int D>
ExcessRange find_excess_range(const ConsolidationModel<D>& model, const std::vector<double>& head,
                              const std::vector<double>& steady) {
  ExcessRange range;
  const auto& mesh = *model.flow->mesh;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (mesh.element_region[e] != mesh::empty_region)
      for (const int node : mesh.elements[e]) {
        const auto n = static_cast<std::size_t>(node);
        const double level = mesh.nodes[n][static_cast<std::size_t>(model.flow->up)];
        const double excess =
            find_excess(model.flow->unit_weight * (head[n] - level), model.flow->unit_weight * (steady[n] - level));
        range = {std::min(range.least, excess), std::max(range.largest, excess)};
      }
  return range;
}

template <int D>
ConsolidationState<D> make_first_state(const ConsolidationModel<D>& model, std::vector<double> head) {
  const SolidSystem<D> system(*model.solid);
  return {SolidAssembly<D>(system, make_laws(*model.solid, 1.0), 1).make_start(), std::move(head)};
}

template <int D>
ConsolidationState<D> carry_state(const ConsolidationModel<D>& old_model, const ConsolidationState<D>& state,
                                  const ConsolidationModel<D>& model, const std::vector<double>& placed_head) {
  constexpr std::size_t points = Quadratic<D>::points;
  const SolidSystem<D> old_system(*old_model.solid), system(*model.solid);
  const std::vector<material::Law> old_laws = make_laws(*old_model.solid, 1.0), laws = make_laws(*model.solid, 1.0);
  ConsolidationState<D> out{SolidAssembly<D>(system, laws, 1).make_start(), placed_head};
  std::fill(out.solid.stress.begin(), out.solid.stress.end(), std::array<double, 6>{});
  std::vector<int> old_element(old_model.solid->mesh->elements.size(), -1);
  for (std::size_t k = 0; k < old_system.mesh.elements.size(); ++k)
    old_element[static_cast<std::size_t>(old_system.mesh.linear_element[k])] = static_cast<int>(k);
  const std::size_t size = out.solid.state.size() / std::max<std::size_t>(1, system.mesh.points.size()),
                    old_size = state.solid.state.size() / std::max<std::size_t>(1, old_system.mesh.points.size());
  for (std::size_t k = 0; k < system.mesh.elements.size(); ++k) {
    const int o = old_element[static_cast<std::size_t>(system.mesh.linear_element[k])];
    if (o < 0) continue;
    const auto old_k = static_cast<std::size_t>(o);
    const auto region = static_cast<std::size_t>(
        model.solid->mesh->element_region[static_cast<std::size_t>(system.mesh.linear_element[k])]);
    // Soil that another law describes from now on keeps its plastic strain alone.
    const std::size_t kept = laws[region].index() == old_laws[region].index() ? std::min(size, old_size)
                                                                              : std::min<std::size_t>(1, old_size);
    for (std::size_t i = 0; i < Quadratic<D>::nodes; ++i)
      out.solid.displacement[static_cast<std::size_t>(system.mesh.elements[k][i])] =
          state.solid.displacement[static_cast<std::size_t>(old_system.mesh.elements[old_k][i])];
    for (std::size_t q = 0; q < points; ++q) {
      const std::size_t p = k * points + q, old_p = old_k * points + q;
      out.solid.stress[p] = state.solid.stress[old_p];
      out.solid.strain[p] = state.solid.strain[old_p];
      out.solid.yields[p] = state.solid.yields[old_p];
      std::copy_n(&state.solid.state[old_p * old_size], kept, &out.solid.state[p * size]);
    }
  }
  start_joints(system, out.solid);
  carry_bars(old_system, state.solid, system, out.solid);
  // Impermeable walls double nodes, and elements keep their numbers.
  const auto &wet = *old_model.flow->mesh, &now = *model.flow->mesh;
  for (std::size_t e = 0; e < wet.elements.size(); ++e)
    if (wet.element_region[e] != mesh::empty_region)
      for (std::size_t i = 0; i <= D; ++i)
        out.head[static_cast<std::size_t>(now.elements[e][i])] =
            state.head[static_cast<std::size_t>(wet.elements[e][i])];
  return out;
}

#define TALUS_INSTANTIATE(D)                                                                                \
  template std::vector<std::array<double, D + 1>> find_corner_stress<D>(const ConsolidationModel<D>&,       \
                                                                        const std::vector<double>&);        \
  template ExcessRange find_excess_range<D>(const ConsolidationModel<D>&, const std::vector<double>&,       \
                                            const std::vector<double>&);                                    \
  template ConsolidationState<D> make_first_state<D>(const ConsolidationModel<D>&, std::vector<double>);    \
  template ConsolidationState<D> carry_state<D>(const ConsolidationModel<D>&, const ConsolidationState<D>&, \
                                                const ConsolidationModel<D>&, const std::vector<double>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::fem
