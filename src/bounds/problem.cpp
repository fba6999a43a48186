// SPDX-License-Identifier: MIT
// Units of the programs of limit analysis, the forces of supports, and the edges of walls.
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
    forces.push_back({bar.from, bar.to, length, {growth * d[0], growth * d[1]}, bar.is_reduced, bar.bar});
  }
  for (const BarHead& head : problem.heads) {
    if (head.wall) continue;
    double width = 0;
    for (const auto& [from, to] : head.sides) width += norm(measure(from, to));
    for (const auto& [from, to] : head.sides)
      forces.push_back({from,
                        to,
                        norm(measure(from, to)),
                        {head.force / width * head.direction[0], head.force / width * head.direction[1]},
                        head.is_reduced,
                        head.bar});
  }
  return forces;
}

std::vector<std::vector<WallEdge>> list_wall_edges(const Problem& problem) {
  std::map<EdgeKey, const Side*> sides;
  for (const Side& s : problem.sides) sides[make_key(s.from, s.to)] = &s;
  std::map<EdgeKey, Edge> edges;
  if (!problem.walls.empty())
    for (const Edge& edge : list_edges(problem.triangles)) edges[make_key(edge.from, edge.to)] = edge;
  std::vector<std::vector<WallEdge>> walls;
  for (const Wall& wall : problem.walls) {
    auto& all = walls.emplace_back();
    for (std::size_t i = 0; i < wall.size(); ++i) {
      WallEdge& made = all.emplace_back();
      made.node = {wall.nodes[i], wall.nodes[i + 1]};
      const Vec<2>&a = problem.nodes[static_cast<std::size_t>(made.node[0])],
            &b = problem.nodes[static_cast<std::size_t>(made.node[1])];
      made.length = std::hypot(b[0] - a[0], b[1] - a[1]);
      made.along = {(b[0] - a[0]) / made.length, (b[1] - a[1]) / made.length};
      made.normal = {-made.along[1], made.along[0]};
      const EdgeKey key = make_key(made.node[0], made.node[1]);
      const auto found = edges.find(key);
      if (found == edges.end()) continue;
      // A triangle is on the left of its edges.
      for (const int e : {found->second.triangle, found->second.other}) {
        if (e < 0) continue;
        const Triangle& t = problem.triangles[static_cast<std::size_t>(e)];
        const std::size_t from = find_corner(t, made.node[0]), to = find_corner(t, made.node[1]);
        made.face[(from + 1) % 3 == to ? 0 : 1] = WallFace{static_cast<std::size_t>(e), {from, to}};
      }
      if (const auto side = sides.find(key); side != sides.end())
        for (std::size_t k = 0; k < 2; ++k)
          made.load[k] = side->second->traction[made.node[k] == side->second->from ? 0 : 1];
    }
  }
  return walls;
}

bool are_walls_sound(const Problem& problem) {
  if (problem.walls.empty()) return true;
  std::set<EdgeKey> keys;
  for (const Wall& wall : problem.walls) {
    for (std::size_t i = 0; i < wall.size(); ++i)
      if (!keys.insert(make_key(wall.nodes[i], wall.nodes[i + 1])).second) return false;
    for (const Strut& strut : wall.struts)
      if (find_wall_node(wall, strut.node) == wall.nodes.size()) return false;
  }
  for (const BarEdge& bar : problem.bars)
    if (keys.contains(make_key(bar.from, bar.to))) return false;
  for (const BarHead& head : problem.heads) {
    if (head.wall && find_wall_node(problem.walls[*head.wall], head.node) == problem.walls[*head.wall].nodes.size())
      return false;
    for (const auto& [from, to] : head.sides)
      if (keys.contains(make_key(from, to))) return false;
  }
  return std::none_of(problem.sides.begin(), problem.sides.end(), [&](const Side& s) {
    return (s.holds_normal || s.holds_along) && keys.contains(make_key(s.from, s.to));
  });
}

std::size_t find_wall_node(const Wall& wall, int node) {
  return static_cast<std::size_t>(std::find(wall.nodes.begin(), wall.nodes.end(), node) - wall.nodes.begin());
}

std::vector<std::vector<WallForce>> list_wall_forces(const Problem& problem) {
  std::vector<std::vector<WallForce>> forces(problem.walls.size());
  for (const BarHead& head : problem.heads)
    if (head.wall)
      forces[*head.wall].push_back({find_wall_node(problem.walls[*head.wall], head.node),
                                    {head.force * head.direction[0], head.force * head.direction[1]},
                                    head.is_reduced,
                                    head.bar});
  return forces;
}

}  // namespace talus::bounds
