// SPDX-License-Identifier: MIT
#include "bounds/uplift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace talus::bounds {

namespace {

/// Excess that counts: more than rounding of the pore pressures, less than what matters to an engineer [Pa].
constexpr double least_excess = 10;

double find_apex(const Strength& soil) {
  double apex = std::numeric_limits<double>::infinity();
  soil.visit_lines([&](double more_cohesion, double tan_friction) {
    if (tan_friction > 0) apex = std::min(apex, (soil.cohesion + more_cohesion) / tan_friction);
  });
  return apex;
}

}  // namespace

std::optional<Uplift> search_uplift(const Problem& problem) {
  std::map<EdgeKey, const Side*> sides;
  for (const Side& side : problem.sides) sides[make_key(side.from, side.to)] = &side;
  std::set<EdgeKey> under_heads;
  for (const BarHead& head : problem.heads)
    for (const auto& side : head.sides) under_heads.insert(make_key(side[0], side[1]));
  std::optional<Uplift> most;
  for (const Edge& edge : list_edges(problem.triangles)) {
    const EdgeKey key = make_key(edge.from, edge.to);
    if (edge.other >= 0 || under_heads.contains(key)) continue;
    const auto found = sides.find(key);
    const Side* side = found == sides.end() ? nullptr : found->second;
    if (side && side->holds_normal) continue;
    const auto e = static_cast<std::size_t>(edge.triangle);
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(edge.from)],
          &b = problem.nodes[static_cast<std::size_t>(edge.to)];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const Vec<2> outward{(b[1] - a[1]) / length, (a[0] - b[0]) / length};
    for (std::size_t end = 0; end < 2; ++end) {
      const std::size_t corner = (static_cast<std::size_t>(edge.side) + end) % 3;
      double pull = problem.pore_pressure[e][corner];
      // A side may be listed against the sense of its triangle.
      if (side) pull += dot(side->traction[side->from == edge.from ? end : 1 - end], outward);
      const double limit = find_apex(problem.strength[e][corner]);
      if (pull - limit > (most ? most->pull - most->limit : least_excess)) most = Uplift{end == 0 ? a : b, pull, limit};
    }
  }
  return most;
}

}  // namespace talus::bounds
