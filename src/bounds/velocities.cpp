// SPDX-License-Identifier: MIT
// Middles of the edges, and what supports leave free.

#include "bounds/velocities.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bounds/strength.hpp"

namespace talus::bounds {

namespace {

/// The body of each node of the six-node triangles, −1 where it is in none.
std::vector<int> find_bodies(const Problem& problem, const Velocities& v, const Units& units) {
  std::vector<int> body(v.nodes.size(), -1), parent(v.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find_root = [&](int n) {
    while (parent[static_cast<std::size_t>(n)] != n) n = parent[static_cast<std::size_t>(n)];
    return n;
  };
  for (std::size_t e = 0; e < problem.size(); ++e) {
    if (!is_rigid(problem.strength[e], units)) continue;
    const int root = find_root(v.triangles[e][0]);
    for (const int n : v.triangles[e]) {
      parent[static_cast<std::size_t>(find_root(n))] = root;
      body[static_cast<std::size_t>(n)] = 0;
    }
  }
  for (std::size_t n = 0; n < body.size(); ++n)
    if (body[n] == 0) body[n] = find_root(static_cast<int>(n));
  return body;
}

/// Motions of a body that its supports leave: `held`, the directions in which some of its nodes are held.
struct BodyMotion {
  std::vector<Vec<2>> held;
  Vec<2> centre{};
  int first = -1;  ///< number of its first motion
};

bool are_parallel(const Vec<2>& a, const Vec<2>& b) {
  return std::abs(a[0] * b[1] - a[1] * b[0]) < 1e-9;
}

/// Freedoms of a node at `x` that moves with its body.
std::vector<Velocities::Freedom> move_with(const BodyMotion& body, const Vec<2>& x, double length) {
  if (body.held.size() > 1) return {};
  if (body.held.size() == 1) return {{{-body.held[0][1], body.held[0][0]}, body.first}};
  return {{{1, 0}, body.first},
          {{0, 1}, body.first + 1},
          {{-(x[1] - body.centre[1]) / length, (x[0] - body.centre[0]) / length}, body.first + 2}};
}

}  // namespace

Velocities number_velocities(const Problem& problem, const Units& units) {
  Velocities v;
  v.nodes = problem.nodes;
  v.triangles.resize(problem.size());
  const std::vector<Edge> edges = list_edges(problem.triangles);
  auto& middles = v.middles;
  for (const Edge& edge : edges) {
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(edge.from)],
          &b = problem.nodes[static_cast<std::size_t>(edge.to)];
    middles[make_key(edge.from, edge.to)] = static_cast<int>(v.nodes.size());
    v.nodes.push_back({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])});
  }
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = problem.triangles[e][i], b = problem.triangles[e][(i + 1) % 3];
      v.triangles[e][i] = a;
      v.triangles[e][3 + i] = middles.at(make_key(a, b));
    }
  // Directions that are held, at most two that differ.
  std::vector<std::vector<Vec<2>>> held(v.nodes.size());
  auto hold = [&](int node, const Vec<2>& direction) {
    auto& own = held[static_cast<std::size_t>(node)];
    const bool known = std::any_of(own.begin(), own.end(), [&](const Vec<2>& h) { return are_parallel(h, direction); });
    if (!known) own.push_back(direction);
  };
  for (const Side& side : problem.sides) {
    const Vec<2>&from = problem.nodes[static_cast<std::size_t>(side.from)],
          &to = problem.nodes[static_cast<std::size_t>(side.to)];
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const Vec<2> along{(to[0] - from[0]) / length, (to[1] - from[1]) / length}, normal{along[1], -along[0]};
    for (const int node : {side.from, side.to, middles.at(make_key(side.from, side.to))}) {
      if (side.holds_normal) hold(node, normal);
      if (side.holds_along) hold(node, along);
    }
  }
  const std::vector<int> bodies = find_bodies(problem, v, units);
  std::map<int, BodyMotion> motions;
  for (std::size_t n = 0; n < v.nodes.size(); ++n) {
    if (bodies[n] < 0) continue;
    BodyMotion& motion = motions[bodies[n]];
    motion.centre = v.nodes[static_cast<std::size_t>(bodies[n])];
    for (const Vec<2>& h : held[n])
      if (motion.held.empty() || !are_parallel(motion.held.front(), h)) motion.held.push_back(h);
  }
  v.freedoms.resize(v.nodes.size());
  for (std::size_t n = 0; n < v.nodes.size(); ++n) {
    if (bodies[n] >= 0) {
      BodyMotion& motion = motions.at(bodies[n]);
      if (motion.first < 0) {
        motion.first = v.count;
        v.count += motion.held.empty() ? 3 : motion.held.size() == 1 ? 1 : 0;
      }
      v.freedoms[n] = move_with(motion, v.nodes[n], units.length);
    } else if (held[n].empty()) {
      v.freedoms[n] = {{{1, 0}, v.count}, {{0, 1}, v.count + 1}};
      v.count += 2;
    } else if (held[n].size() == 1) {
      v.freedoms[n] = {{{-held[n][0][1], held[n][0][0]}, v.count++}};
    }
  }
  return v;
}

}  // namespace talus::bounds
