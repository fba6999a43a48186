// SPDX-License-Identifier: MIT
// Where wet soil ends, and the pressure of the water outside.

#include <algorithm>
#include <cmath>

#include "mesh/shape_gradient.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/water_surface.hpp"

namespace talus::mpm {
namespace {

constexpr double closed_share = 1e-9;

template <int D>
bool is_wet(const Body<D>& body, int e) {
  return e >= 0 && body.water.volume[e] > 0;
}

/// Whether the water of node `i` may not move along the unit vector `n`.
template <int D>
bool is_held(const Water<D>& water, int i, const std::type_identity_t<Vec<D>>& n) {
  const int c = water.constraint_of_node[i];
  return c >= 0 && norm(remove_fixed<D>(water.constraints[c].fixed, water.constraints[c].fixed_count, n)) < 1e-9;
}

/// A side of a wet element is open when no wet element is behind it, unless its nodes all hold the water.
template <int D>
void find_open_sides(Body<D>& body) {
  Water<D>& water = body.water;
  const mesh::Mesh<D>& mesh = body.mesh();
  water.open_sides.clear();
  water.facing.assign(mesh.nodes.size(), Vec<D>{});
  std::vector<Vec<D>> touching(mesh.nodes.size(), Vec<D>{});
  std::vector<double> size(mesh.nodes.size(), 0.0);
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (!is_wet(body, e)) continue;
    for (int k = 0; k <= D; ++k) {
      if (is_wet(body, mesh.neighbours[e][k])) continue;
      OpenSide<D> side{e, k, mesh::find_shape_gradient(mesh, e, k)};
      for (double& c : side.share) c *= -mesh.volumes[e];
      Vec<D> normal = side.share;
      for (double& c : normal) c /= norm(side.share);
      bool closed = true;
      for (int i = 0; i <= D; ++i) closed = closed && (i == k || is_held(water, mesh.elements[e][i], normal));
      if (closed) continue;
      for (int i = 0; i <= D; ++i) {
        const int node = mesh.elements[e][i];
        for (int d = 0; d < D; ++d) {
          water.facing[node][d] += side.share[d];
          if (i != k) touching[node][d] += side.share[d];
        }
        size[node] += norm(side.share);
      }
      water.open_sides.push_back(side);
    }
  }
  // Where the open sides of a node's elements close round it, as those of a lone element do, their sum is round-off,
  // and the sides that touch the node say where outside is.
  for (std::size_t i = 0; i < size.size(); ++i) {
    if (norm(water.facing[i]) <= closed_share * size[i]) water.facing[i] = touching[i];
  }
  water.surface_is_stale = false;
}

/// Mean pressure of the elements at the surface round each of its nodes: what limits evaporation.
template <int D>
void find_suctions(Body<D>& body) {
  Water<D>& water = body.water;
  water.suction.assign(body.mesh().nodes.size(), 0.0);
  std::vector<int> count(body.mesh().nodes.size(), 0);
  int last = -1;
  for (const OpenSide<D>& side : water.open_sides) {  // the sides of an element follow one another
    if (side.element == last) continue;
    last = side.element;
    for (int i : body.mesh().elements[side.element]) {
      water.suction[i] += water.mean_pressure[side.element];
      ++count[i];
    }
  }
  for (std::size_t i = 0; i < count.size(); ++i) {
    if (count[i] > 0) water.suction[i] /= count[i];
  }
}

/// Forces of the water outside, linear along a side between the pressures at its nodes, where all of them have such a
/// condition: on the water; on the mixture when it presses.
template <int D>
void load_open_sides(Body<D>& body, double unit_weight, const std::type_identity_t<Vec<D>>& up) {
  Water<D>& water = body.water;
  const mesh::Mesh<D>& mesh = body.mesh();
  water.load.assign(mesh.nodes.size(), Vec<D>{});
  water.mixture_load.assign(mesh.nodes.size(), Vec<D>{});
  for (const OpenSide<D>& side : water.open_sides) {
    double pressure[D + 1] = {}, sum = 0;
    bool loaded = true;
    for (int i = 0; i <= D && loaded; ++i) {
      if (i == side.opposite) continue;
      const int node = mesh.elements[side.element][i];
      const SurfaceCondition& c = water.surfaces[water.surface_of_node[node]];
      const double value = c.value.time.empty() ? 0.0 : c.value.at(body.time);
      if (c.kind == SurfaceKind::head)
        pressure[i] = -unit_weight * std::max(0.0, find_submergence<D>(value, up, mesh.nodes[node]));
      else if (c.kind == SurfaceKind::pressure)
        pressure[i] = value;
      else
        loaded = false;
      sum += pressure[i];
    }
    if (!loaded) continue;
    for (int i = 0; i <= D; ++i) {
      if (i == side.opposite) continue;
      const int node = mesh.elements[side.element][i];
      const double mean = (sum + pressure[i]) / (D + 1);
      for (int d = 0; d < D; ++d) {
        water.load[node][d] += mean * side.share[d];
        water.mixture_load[node][d] += std::min(0.0, mean) * side.share[d];
      }
    }
  }
}

}  // namespace

template <int D>
void load_surface(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  if (water.surface_is_stale) find_open_sides(body);
  bool loads = false, evaporates = false;
  for (const SurfaceCondition& c : water.surfaces) {
    loads = loads || c.kind == SurfaceKind::head || c.kind == SurfaceKind::pressure;
    evaporates = evaporates || (c.kind == SurfaceKind::rain && !std::isinf(c.suction_limit));
  }
  if (loads) load_open_sides(body, water.density * norm(o.gravity), find_up<D>(o.gravity));
  if (evaporates) find_suctions(body);
}

template void load_surface<2>(Body<2>&, const StepOptions<2>&);
template void load_surface<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
