// SPDX-License-Identifier: MIT
// Heads of steady flow under the boundary conditions of a time, body by body of the soil.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "fem/consolidation/consolidation.hpp"
#include "fem/seepage/newton.hpp"
#include "fem/seepage/system.hpp"

namespace talus::fem {
namespace {

/// Heads above a face by less than this, over the height of the soil, are rounding.
constexpr double rounding = 1e-9;

/// The parts of the soil that water can pass between.
template <int D>
class Bodies {
 public:
  explicit Bodies(const SeepageSystem<D>& system) : body_(static_cast<std::size_t>(system.size())) {
    std::iota(body_.begin(), body_.end(), std::size_t{0});
    for (const int e : system.elements) {
      const auto& nodes = system.model.mesh->elements[static_cast<std::size_t>(e)];
      const auto find_unknown = [&](std::size_t k) {
        return static_cast<std::size_t>(system.unknown_of_node[static_cast<std::size_t>(nodes[k])]);
      };
      for (std::size_t k = 1; k <= D; ++k) body_[find(find_unknown(k))] = find(find_unknown(0));
    }
    for (std::size_t u = 0; u < body_.size(); ++u) body_[u] = find(u);
  }
  std::size_t operator[](std::size_t unknown) const { return body_[unknown]; }
  std::size_t size() const { return body_.size(); }

 private:
  std::size_t find(std::size_t u) {
    while (body_[u] != u) u = body_[u] = body_[body_[u]];
    return u;
  }
  std::vector<std::size_t> body_;
};

/// Returns for every unknown whether the conditions of its body have one steady state: a head is given, or water that
/// enters leaves elsewhere.
template <int D>
std::vector<char> find_given(const SeepageSystem<D>& system, const std::vector<NodeCondition>& conditions,
                             const Bodies<D>& bodies) {
  std::vector<char> has_head(bodies.size(), 0), has_outlet(bodies.size(), 0), has_supply(bodies.size(), 0);
  for (std::size_t u = 0; u < conditions.size(); ++u) {
    const NodeCondition& c = conditions[u];
    if (c.fixed) has_head[bodies[u]] = 1;
    if (c.face) has_outlet[bodies[u]] = 1;
    if (c.given > 0 || c.offered > 0) has_supply[bodies[u]] = 1;
  }
  for (std::size_t b = 0; b < system.shares.size(); ++b)
    if (system.model.boundaries[b].kind == HydraulicKind::free_drainage)
      for (const BoundaryShare& share : system.shares[b])
        has_outlet[bodies[static_cast<std::size_t>(share.unknown)]] = 1;
  std::vector<char> given(bodies.size());
  for (std::size_t u = 0; u < given.size(); ++u)
    given[u] = has_head[bodies[u]] != 0 || (has_outlet[bodies[u]] != 0 && has_supply[bodies[u]] != 0);
  return given;
}

/// Lowers heads that are kept to the lowest face from which water would flow out under them.
template <int D>
bool lower_to_faces(const SeepageSystem<D>& system, const std::vector<NodeCondition>& conditions,
                    const Bodies<D>& bodies, const std::vector<char>& given, std::vector<double>& head) {
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> outlet(bodies.size(), infinity);
  const auto [low, high] = std::minmax_element(system.elevation.begin(), system.elevation.end());
  const double height = *high - *low;
  std::vector<char> flows(bodies.size(), 0);
  for (std::size_t u = 0; u < conditions.size(); ++u) {
    if (given[u] != 0 || !conditions[u].face) continue;
    const std::size_t b = bodies[u];
    outlet[b] = std::min(outlet[b], system.elevation[u]);
    if (head[u] > system.elevation[u] + rounding * height) flows[b] = 1;
  }
  bool is_lowered = false;
  for (std::size_t u = 0; u < head.size(); ++u) {
    if (given[u] != 0 || flows[bodies[u]] == 0 || head[u] <= outlet[bodies[u]]) continue;
    head[u] = outlet[bodies[u]];
    is_lowered = true;
  }
  return is_lowered;
}

/// Returns the model of the bodies that have a steady state; `mesh` is theirs.
template <int D>
SeepageModel<D> select_given(const SeepageSystem<D>& system, const std::vector<char>& given, mesh::Mesh<D>& mesh) {
  const auto has_steady = [&](int node) {
    const int u = system.unknown_of_node[static_cast<std::size_t>(node)];
    return u >= 0 && given[static_cast<std::size_t>(u)] != 0;
  };
  mesh = *system.model.mesh;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    if (!has_steady(mesh.elements[e][0])) mesh.element_region[e] = mesh::empty_region;
  SeepageModel<D> model = system.model;
  model.mesh = &mesh;
  for (HydraulicBoundary<D>& boundary : model.boundaries)
    std::erase_if(boundary.sides, [&](const auto& side) { return !has_steady(side[0]); });
  std::erase_if(model.boundaries, [](const auto& boundary) { return boundary.sides.empty(); });
  return model;
}

}  // namespace

template <int D>
SteadyHeads<D> find_steady_heads(const SeepageModel<D>& flow, const std::vector<double>& kept, double time,
                                 const std::vector<double>& guess) {
  const SeepageSystem<D> system(flow);
  const std::vector<NodeCondition> conditions = system.find_conditions(time);
  const Bodies<D> bodies(system);
  const std::vector<char> given = find_given(system, conditions, bodies);
  const auto is_given = [](char g) { return g != 0; };
  SteadyHeads<D> result;
  if (std::all_of(given.begin(), given.end(), is_given)) {
    result.head = solve_steady_seepage<D>(flow, {}, guess, time).head;
    return result;
  }
  std::vector<double> head = to_unknowns(system, kept);
  result.is_given = false;
  result.is_lowered = lower_to_faces(system, conditions, bodies, given, head);
  result.head = to_nodes(system, head);
  if (std::none_of(given.begin(), given.end(), is_given)) return result;
  mesh::Mesh<D> mesh;
  const std::vector<double> solved = solve_steady_seepage<D>(select_given(system, given, mesh), {}, guess, time).head;
  for (std::size_t u = 0; u < given.size(); ++u)
    if (given[u] != 0) {
      const auto node = static_cast<std::size_t>(system.node_of_unknown[u]);
      result.head[node] = solved[node];
    }
  return result;
}

double find_excess(double pressure, double steady) {
  return pressure < steady ? pressure - steady : std::max(pressure, 0.0) - std::max(steady, 0.0);
}

template SteadyHeads<2> find_steady_heads<2>(const SeepageModel<2>&, const std::vector<double>&, double,
                                             const std::vector<double>&);
template SteadyHeads<3> find_steady_heads<3>(const SeepageModel<3>&, const std::vector<double>&, double,
                                             const std::vector<double>&);

}  // namespace talus::fem
