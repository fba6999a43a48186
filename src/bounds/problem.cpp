// SPDX-License-Identifier: MIT
// Units of the programs of limit analysis, and the forces of supports.
#include "bounds/problem.hpp"

#include <algorithm>

namespace talus::bounds {

Units find_units(const Problem& problem) {
  Units units{0, 0};
  Vec<2> low = problem.nodes.front(), high = low;
  for (const Vec<2>& x : problem.nodes)
    for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
  units.length = high[1] - low[1];
  for (const Vec<2>& b : problem.body_force) units.stress = std::max(units.stress, norm(b) * units.length);
  for (const Side& s : problem.sides)
    for (const Vec<2>& t : s.traction) units.stress = std::max(units.stress, norm(t));
  if (!(units.stress > 0)) units.stress = 1;
  return units;
}

std::vector<LineForce> list_line_forces(const Problem& problem) {
  const auto measure = [&](int from, int to) {
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(from)], &b = problem.nodes[static_cast<std::size_t>(to)];
    return Vec<2>{b[0] - a[0], b[1] - a[1]};
  };
  std::vector<LineForce> forces;
  for (const BarEdge& bar : problem.bars) {
    const Vec<2> d = measure(bar.from, bar.to);
    const double length = norm(d), growth = (bar.force[1] - bar.force[0]) / (length * length);
    forces.push_back({bar.from, bar.to, length, {growth * d[0], growth * d[1]}, bar.is_reduced});
  }
  for (const BarHead& head : problem.heads) {
    double width = 0;
    for (const auto& [from, to] : head.sides) width += norm(measure(from, to));
    for (const auto& [from, to] : head.sides)
      forces.push_back({from,
                        to,
                        norm(measure(from, to)),
                        {head.force / width * head.direction[0], head.force / width * head.direction[1]},
                        head.is_reduced});
  }
  return forces;
}

}  // namespace talus::bounds
