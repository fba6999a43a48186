// SPDX-License-Identifier: MIT
// Boundary values in time, and the areas and conditions of the nodes on the border of the soil.
#include "fem/seepage/hydraulic_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "fem/seepage/seepage.hpp"
#include "fem/seepage/system.hpp"

namespace talus::fem {

template <int D>
double HydraulicBoundary<D>::value_at(double time) const {
  if (history.empty()) return value;
  std::size_t next = 0;
  while (next < history.size() && history[next][0] <= time) ++next;
  if (next == 0) return history.front()[1];
  if (next == history.size()) return history.back()[1];
  const auto &a = history[next - 1], &b = history[next];
  return a[1] + (b[1] - a[1]) * (time - a[0]) / (b[0] - a[0]);
}

template struct HydraulicBoundary<2>;
template struct HydraulicBoundary<3>;

// The border of the soil: the areas that belong to its nodes, and their conditions in time.

namespace {

/// Returns the area vector of a side, directed away from the node of the element that is not on it.
template <int D>
std::array<double, D> find_area_vector(const mesh::Mesh<D>& mesh, const typename mesh::Mesh<D>::Side& side,
                                       int inner_node) {
  const auto& a = mesh.nodes[static_cast<std::size_t>(side[0])];
  const auto& b = mesh.nodes[static_cast<std::size_t>(side[1])];
  std::array<double, D> area;
  if constexpr (D == 2) {
    area = {b[1] - a[1], a[0] - b[0]};
  } else {
    const auto& c = mesh.nodes[static_cast<std::size_t>(side[2])];
    const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    area = {0.5 * (u[1] * v[2] - u[2] * v[1]), 0.5 * (u[2] * v[0] - u[0] * v[2]), 0.5 * (u[0] * v[1] - u[1] * v[0])};
  }
  double inward = 0;
  for (std::size_t d = 0; d < D; ++d) inward += area[d] * (mesh.nodes[static_cast<std::size_t>(inner_node)][d] - a[d]);
  if (inward > 0) {
    for (double& x : area) x = -x;
  }
  return area;
}

/// Results of find_owner() where no soil element, or two, have a side.
constexpr int no_soil = -1, soil_on_both_sides = -2;

template <int D>
int find_owner(const mesh::Mesh<D>& mesh, const std::vector<std::vector<int>>& elements_of_node,
               const typename mesh::Mesh<D>::Side& side) {
  int owner = no_soil;
  for (int e : elements_of_node[static_cast<std::size_t>(side[0])]) {
    const auto& nodes = mesh.elements[static_cast<std::size_t>(e)];
    const bool holds = std::all_of(side.begin(), side.end(),
                                   [&](int i) { return std::find(nodes.begin(), nodes.end(), i) != nodes.end(); });
    if (!holds) continue;
    if (owner >= 0) return soil_on_both_sides;
    owner = e;
  }
  return owner;
}

}  // namespace

template <int D>
void build_shares(SeepageSystem<D>& s) {
  const auto& mesh = *s.model.mesh;
  std::vector<std::vector<int>> elements_of_node(mesh.nodes.size());
  for (int e : s.elements) {
    for (int node : mesh.elements[static_cast<std::size_t>(e)])
      elements_of_node[static_cast<std::size_t>(node)].push_back(e);
  }
  for (const auto& boundary : s.model.boundaries) {
    std::map<int, BoundaryShare> share;
    for (const auto& side : boundary.sides) {
      const int owner = find_owner(mesh, elements_of_node, side);
      if (owner == no_soil) continue;  // a side of the box continues above the ground
      if (owner == soil_on_both_sides) fail_input(describe_inner_side(s.model, boundary.name, side));
      int inner = -1;
      for (int node : mesh.elements[static_cast<std::size_t>(owner)]) {
        if (std::find(side.begin(), side.end(), node) == side.end()) inner = node;
      }
      const auto area = find_area_vector<D>(mesh, side, inner);
      const auto up = static_cast<std::size_t>(s.model.up);
      const int soil = mesh.element_region[static_cast<std::size_t>(owner)];
      const auto& hydraulic = s.model.soils[static_cast<std::size_t>(soil)];
      // Outflow at a unit gradient along `up`, K_xy included.
      double downward = -hydraulic.conductivity[up] * area[up];
      if (up < 2) downward -= hydraulic.cross_conductivity * area[1 - up];
      if (!(area[up] < 0)) downward = 0;
      double length = 0;
      for (double a : area) length += a * a;
      for (int node : side) {
        const int u = s.unknown_of_node[static_cast<std::size_t>(node)];
        BoundaryShare& b = share.try_emplace(u, BoundaryShare{u, soil, 0, 0, 0}).first->second;
        b.area += std::sqrt(length) / D;
        b.horizontal += area[up] / D;
        b.downward += std::max(0.0, downward) / D;
      }
    }
    if (share.empty()) fail_input("The hydraulic boundary \"" + boundary.name + "\" lies on no surface of the soil.");
    auto& list = s.shares.emplace_back();
    for (const auto& [u, b] : share) list.push_back(b);
  }
}

template <int D>
std::vector<NodeCondition> SeepageSystem<D>::find_conditions(double time) const {
  std::vector<NodeCondition> conditions(node_of_unknown.size());
  for (std::size_t b = 0; b < shares.size(); ++b) {
    const auto& boundary = model.boundaries[b];
    const auto kind = boundary.kind;
    const bool is_level = kind == HydraulicKind::total_head || kind == HydraulicKind::reservoir;
    const double value = boundary.value_at(time) - (is_level ? datum : 0);
    for (const BoundaryShare& share : shares[b]) {
      const auto u = static_cast<std::size_t>(share.unknown);
      NodeCondition& c = conditions[u];
      if (!boundary.levels.empty()) {
        const double level = boundary.levels[static_cast<std::size_t>(node_of_unknown[u])] - datum;
        if (c.fixed) continue;
        if (level > elevation[u]) {
          c.owner = static_cast<int>(b);
          c.fixed = true;
          c.head = level;
          continue;
        }
      }
      const bool submerged = elevation[u] <= value;
      if (kind == HydraulicKind::total_head || kind == HydraulicKind::pressure ||
          (kind == HydraulicKind::reservoir && submerged)) {
        const double head = kind == HydraulicKind::pressure ? elevation[u] - value / model.unit_weight : value;
        if (c.fixed && std::abs(c.head - head) > 1e-9 * std::max({1.0, std::abs(head), std::abs(c.head)}))
          fail_input(describe_contradiction(model, node_of_unknown[u],
                                            model.boundaries[static_cast<std::size_t>(c.owner)].name, c.head + datum,
                                            boundary.name, head + datum));
        if (!c.fixed) c.owner = static_cast<int>(b);
        c.fixed = true;
        c.head = head;
        continue;
      }
      const double area = boundary.measure == FluxMeasure::vertical ? std::max(0.0, share.horizontal) : share.area;
      if (kind == HydraulicKind::flux) c.given += value * area;
      if (kind == HydraulicKind::rain || kind == HydraulicKind::seepage_face || kind == HydraulicKind::reservoir) {
        c.face = true;
        if (c.owner < 0) c.owner = static_cast<int>(b);
        if (kind == HydraulicKind::rain) {
          c.offered += value * area;
          c.suction_limit = std::min(c.suction_limit, boundary.suction_limit);
        }
      }
    }
  }
  return conditions;
}

template void build_shares<2>(SeepageSystem<2>&);
template void build_shares<3>(SeepageSystem<3>&);
template std::vector<NodeCondition> SeepageSystem<2>::find_conditions(double) const;
template std::vector<NodeCondition> SeepageSystem<3>::find_conditions(double) const;

}  // namespace talus::fem
