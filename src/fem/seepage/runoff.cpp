// SPDX-License-Identifier: MIT
// Drainage network of the ground, and the routing of rain that does not infiltrate.
#include "fem/seepage/newton.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>

namespace talus::fem {

namespace {

/// Run-on has converged when it changes by less than this fraction of all supplied water.
constexpr double close = 1e-7;

/// Returns the edges of the ground as pairs of unknowns: those of all sides with a condition, except the walls of the
/// box.
template <int D>
std::set<std::array<int, 2>> list_edges(const SeepageSystem<D>& system) {
  const auto& mesh = *system.model.mesh;
  const auto up = static_cast<std::size_t>(system.model.up);
  std::array<double, D> low{}, high{};
  for (std::size_t d = 0; d < D; ++d) {
    const auto by = [d](const auto& a, const auto& b) { return a[d] < b[d]; };
    low[d] = (*std::min_element(mesh.nodes.begin(), mesh.nodes.end(), by))[d];
    high[d] = (*std::max_element(mesh.nodes.begin(), mesh.nodes.end(), by))[d];
  }
  const auto is_wall = [&](const typename mesh::Mesh<D>::Side& side) {
    for (std::size_t d = 0; d < D; ++d) {
      const double near = 1e-9 * (high[d] - low[d]);
      for (const double x : {low[d], high[d]}) {
        if (d == up && x == high[d]) continue;
        if (std::all_of(side.begin(), side.end(),
                        [&](int node) { return std::abs(mesh.nodes[static_cast<std::size_t>(node)][d] - x) <= near; }))
          return true;
      }
    }
    return false;
  };
  std::set<std::array<int, 2>> edges;
  for (const auto& boundary : system.model.boundaries)
    for (const auto& side : boundary.sides) {
      if (is_wall(side)) continue;
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t j = i + 1; j < D; ++j) {
          const int a = system.unknown_of_node[static_cast<std::size_t>(side[i])],
                    b = system.unknown_of_node[static_cast<std::size_t>(side[j])];
          if (a >= 0 && b >= 0) edges.insert({std::min(a, b), std::max(a, b)});
        }
    }
  return edges;
}

}  // namespace

template <int D>
Runoff<D>::Runoff(const SeepageSystem<D>& system) : system_(system) {
  const auto size = system.elevation.size();
  capacity_.assign(size, 0);
  for (std::size_t b = 0; b < system.shares.size(); ++b) {
    const auto& boundary = system.model.boundaries[b];
    used_ = used_ || boundary.runs_on || boundary.standing_depth > 0;
    for (const BoundaryShare& share : system.shares[b])
      capacity_[static_cast<std::size_t>(share.unknown)] += boundary.standing_depth * std::max(0.0, share.horizontal);
  }
  standing_.assign(size, 0);
  now_ = run_on_ = next_ = standing_;
  receiver_.assign(size, -1);
  if (!used_) return;
  const bool runs_on = std::any_of(system.model.boundaries.begin(), system.model.boundaries.end(),
                                   [](const auto& b) { return b.runs_on; });
  std::vector<std::vector<int>> neighbours(size);
  std::set<int> ground;
  for (const auto& [a, b] : list_edges(system)) {
    neighbours[static_cast<std::size_t>(a)].push_back(b);
    neighbours[static_cast<std::size_t>(b)].push_back(a);
    ground.insert({a, b});
  }
  const auto height = [&](int u) { return system.elevation[static_cast<std::size_t>(u)]; };
  const auto place = [&](int u) {
    return system.model.mesh->nodes[static_cast<std::size_t>(system.node_of_unknown[static_cast<std::size_t>(u)])];
  };
  std::queue<int> drained;  // nodes with a receiver, to which level ground drains
  for (const int u : ground) {
    double steepest = 0;
    for (const int v : neighbours[static_cast<std::size_t>(u)]) {
      double length = 0;
      for (std::size_t d = 0; d < D; ++d) length += std::pow(place(v)[d] - place(u)[d], 2);
      const double slope = (height(u) - height(v)) / std::sqrt(length);
      if (slope > std::max(steepest, 1e-9)) steepest = slope, receiver_[static_cast<std::size_t>(u)] = v;
    }
    if (steepest > 0) drained.push(u);
  }
  while (!drained.empty()) {
    const int u = drained.front();
    drained.pop();
    for (const int v : neighbours[static_cast<std::size_t>(u)]) {
      int& to = receiver_[static_cast<std::size_t>(v)];
      const bool is_level = std::abs(height(v) - height(u)) <= 1e-9 * std::max(1.0, std::abs(height(u)));
      if (to < 0 && is_level && receiver_[static_cast<std::size_t>(u)] != v) to = u, drained.push(v);
    }
  }
  // From the highest node down; level ground in the direction of its flow.
  std::vector<int> givers(size, 0);
  for (const int u : ground)
    if (const int v = receiver_[static_cast<std::size_t>(u)]; v >= 0) ++givers[static_cast<std::size_t>(v)];
  for (const int u : ground)
    if (givers[static_cast<std::size_t>(u)] == 0) order_.push_back(u);
  for (std::size_t i = 0; i < order_.size(); ++i)
    if (const int v = receiver_[static_cast<std::size_t>(order_[i])];
        v >= 0 && --givers[static_cast<std::size_t>(v)] == 0)
      order_.push_back(v);
  if (!runs_on) receiver_.assign(size, -1);
}

template <int D>
void Runoff<D>::offer(double dt, std::vector<NodeCondition>& conditions) const {
  for (const int unknown : order_) {
    const auto u = static_cast<std::size_t>(unknown);
    NodeCondition& c = conditions[u];
    if (!c.face || c.fixed) continue;
    c.carried = run_on_[u] + standing_[u] / dt;
    c.offered += c.carried;
  }
}

template <int D>
bool Runoff<D>::route(double dt, const std::vector<NodeCondition>& conditions, const SeepageState& state,
                      const NodalSums& sums) {
  std::fill(next_.begin(), next_.end(), 0.0);
  double all = 0;
  for (const int unknown : order_) {
    const auto u = static_cast<std::size_t>(unknown);
    const NodeCondition& c = conditions[u];
    // Rain on a pool belongs to the pool; an unsaturated face takes all supplied water, and may take more.
    now_[u] = 0;
    if (c.fixed || !c.face) continue;
    const double change = next_[u] - run_on_[u], offered = c.offered + change;
    all += std::abs(offered);
    const double enters = state.face[u] == FaceState::wet ? sums.outflow[u] - c.given : offered;
    const double rest = std::max(0.0, offered - enters);
    now_[u] = std::min(rest * dt, capacity_[u]);
    if (receiver_[u] >= 0) next_[static_cast<std::size_t>(receiver_[u])] += rest - now_[u] / dt;
  }
  double largest = 0;
  for (std::size_t u = 0; u < next_.size(); ++u) {
    const NodeCondition& c = conditions[u];
    if (c.face && !c.fixed) largest = std::max(largest, std::abs(next_[u] - run_on_[u]));
  }
  run_on_ = next_;
  return largest <= close * all;
}

template <int D>
void Runoff<D>::end_step(double dt, const std::vector<NodeCondition>& conditions, SeepageResult<D>& result) {
  for (const int unknown : order_) {
    const auto u = static_cast<std::size_t>(unknown);
    const double growth = (now_[u] - standing_[u]) / dt;
    standing_[u] = now_[u];
    if (growth == 0 || conditions[u].owner < 0) continue;
    Discharge& d = result.discharges[static_cast<std::size_t>(conditions[u].owner)];
    d.standing += growth;
    d.runoff -= growth;
  }
}

template class Runoff<2>;
template class Runoff<3>;

}  // namespace talus::fem
