// SPDX-License-Identifier: MIT
// Problems on bisected triangles, and the corners of the border where stress may jump.
#include "bounds/refine.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "bounds/problem.hpp"
#include "mesh/bisect.hpp"

namespace talus::bounds {

namespace {

double find_angle(const Problem& problem, const Triangle& t, std::size_t i) {
  const auto get = [&](std::size_t k) -> const Vec<2>& { return problem.nodes[static_cast<std::size_t>(t[k % 3])]; };
  const double ax = get(i + 1)[0] - get(i)[0], ay = get(i + 1)[1] - get(i)[1], bx = get(i + 2)[0] - get(i)[0],
               by = get(i + 2)[1] - get(i)[1];
  return std::atan2(ax * by - ay * bx, ax * bx + ay * by);
}

/// Replaces the triangles of a problem by those of a bisection, with sides, bars and walls.
class Subdivision {
 public:
  Subdivision(const Problem& problem, mesh::Bisection parts) : from_(problem), parts_(std::move(parts)), to_(problem) {}

  Problem run() {
    to_.nodes = std::move(parts_.nodes);
    to_.triangles = std::move(parts_.triangles);
    to_.region.clear(), to_.strength.clear(), to_.body_force.clear(), to_.pore_pressure.clear();
    for (std::size_t e = 0; e < to_.size(); ++e) add_soil(parts_.parent[e], parts_.weights[e]);
    to_.sides.clear();
    for (const Side& s : from_.sides) {
      const auto middle = find_middle(s.from, s.to);
      if (!middle) {
        to_.sides.push_back(s);
        continue;
      }
      Side first = s, second = s;
      first.to = second.from = *middle;
      for (std::size_t d = 0; d < 2; ++d)
        first.traction[1][d] = second.traction[0][d] = 0.5 * (s.traction[0][d] + s.traction[1][d]);
      to_.sides.push_back(first), to_.sides.push_back(second);
    }
    split_bars();
    split_walls();
    return std::move(to_);
  }

 private:
  std::optional<int> find_middle(int a, int b) const {
    const auto found = parts_.middles.find(make_key(a, b));
    return found == parts_.middles.end() ? std::nullopt : std::optional(found->second);
  }

  /// Interpolates strength and pressure in the triangle `parent` at the corners of a part of it.
  void add_soil(std::size_t parent, const std::array<std::array<double, 3>, 3>& w) {
    to_.region.push_back(from_.region[parent]);
    to_.body_force.push_back(from_.body_force[parent]);
    std::array<Strength, 3> strength;
    std::array<double, 3> pore{};
    for (std::size_t i = 0; i < 3; ++i) {
      Strength s = from_.strength[parent][0];
      s.cohesion = 0, s.tan_friction = 0;
      if (s.tension) s.tension = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Strength& own = from_.strength[parent][k];
        s.cohesion += w[i][k] * own.cohesion, s.tan_friction += w[i][k] * own.tan_friction;
        if (s.tension) *s.tension += w[i][k] * *own.tension;
        pore[i] += w[i][k] * from_.pore_pressure[parent][k];
      }
      strength[i] = s;
    }
    to_.strength.push_back(strength), to_.pore_pressure.push_back(pore);
  }

  void split_bars() {
    to_.bars.clear();
    for (const BarEdge& bar : from_.bars) {
      BarEdge first = bar, second = bar;
      if (const auto middle = find_middle(bar.from, bar.to)) {
        first.to = second.from = *middle;
        first.force[1] = second.force[0] = 0.5 * (bar.force[0] + bar.force[1]);
        to_.bars.push_back(first);
      }
      to_.bars.push_back(second);
    }
    for (BarHead& head : to_.heads) {
      std::vector<std::array<int, 2>> sides;
      for (const auto& [from, to] : head.sides) {
        const auto middle = find_middle(from, to);
        if (middle) sides.push_back({from, *middle});
        sides.push_back({middle.value_or(from), to});
      }
      head.sides = std::move(sides);
    }
  }

  void split_walls() {
    for (Wall& wall : to_.walls) {
      std::vector<int> nodes{wall.nodes.front()};
      std::vector<std::array<InterfaceStrength, 2>> interface;
      for (std::size_t i = 0; i < wall.size(); ++i) {
        for (const int node : {find_middle(wall.nodes[i], wall.nodes[i + 1]).value_or(-1), wall.nodes[i + 1]}) {
          if (node < 0) continue;
          nodes.push_back(node);
          interface.push_back(wall.interface[i]);
        }
      }
      wall.nodes = std::move(nodes), wall.interface = std::move(interface);
    }
  }

  const Problem& from_;
  mesh::Bisection parts_;
  Problem to_;
};

}  // namespace

Problem refine(const Problem& problem, const std::vector<bool>& marked) {
  mesh::Bisector bisector(problem.nodes, problem.triangles);
  for (std::size_t e = 0; e < problem.size(); ++e)
    if (marked[e]) bisector.mark(bisector.find_longest(problem.triangles[e]));
  return Subdivision(problem, bisector.run(true)).run();
}

Problem fan_out(const Problem& problem, const std::vector<int>& nodes, double widest) {
  Problem finer = problem;
  for (;;) {
    mesh::Bisector bisector(finer.nodes, finer.triangles);
    for (const Triangle& t : finer.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (std::find(nodes.begin(), nodes.end(), t[i]) != nodes.end() && find_angle(finer, t, i) > widest)
          bisector.mark(make_key(t[(i + 1) % 3], t[(i + 2) % 3]));
    if (!bisector.has_marked()) return finer;
    finer = Subdivision(finer, bisector.run(false)).run();
  }
}

std::vector<int> find_corners(const Problem& problem) {
  // For each node of the border: direction, traction and support of its two sides.
  struct End {
    Vec<2> direction, traction;
    bool holds_normal, holds_along;
  };
  constexpr double rounding = 1e-9;  ///< over the largest traction
  double largest = 0;
  std::map<std::pair<int, int>, const Side*> sides;
  for (const Side& s : problem.sides) {
    sides[make_key(s.from, s.to)] = &s;
    for (const Vec<2>& t : s.traction) largest = std::max({largest, std::abs(t[0]), std::abs(t[1])});
  }
  std::map<int, std::vector<End>> ends;
  for (const Edge& edge : list_edges(problem.triangles)) {
    if (edge.other >= 0) continue;
    const auto found = sides.find(make_key(edge.from, edge.to));
    const Side* side = found == sides.end() ? nullptr : found->second;
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(edge.from)],
          &b = problem.nodes[static_cast<std::size_t>(edge.to)];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    for (const int node : {edge.from, edge.to})
      ends[node].push_back({{(b[0] - a[0]) / length, (b[1] - a[1]) / length},
                            side ? side->traction[node == side->from ? 0 : 1] : Vec<2>{0, 0},
                            side && side->holds_normal,
                            side && side->holds_along});
  }
  std::vector<int> corners;
  for (const auto& [node, both] : ends) {
    if (both.size() != 2) continue;
    const End &p = both[0], &q = both[1];
    const bool turns = std::abs(p.direction[0] * q.direction[1] - p.direction[1] * q.direction[0]) > 0.05;
    const bool free = !p.holds_normal && !p.holds_along && !q.holds_normal && !q.holds_along;
    const bool jumps = std::abs(p.traction[0] - q.traction[0]) > rounding * largest ||
                       std::abs(p.traction[1] - q.traction[1]) > rounding * largest;
    if ((turns && free) || jumps || p.holds_along != q.holds_along) corners.push_back(node);
  }
  // The tractions of bars and heads jump to zero at their ends, where two triangles could not balance them.
  const auto add_ends = [&](const std::map<int, int>& uses) {
    for (const auto& [node, count] : uses)
      if (count == 1) corners.push_back(node);
  };
  std::map<int, int> uses;
  for (const BarEdge& bar : problem.bars) ++uses[bar.from], ++uses[bar.to];
  add_ends(uses);
  for (const Wall& wall : problem.walls) corners.push_back(wall.nodes.back());
  for (const BarHead& head : problem.heads) {
    uses.clear();
    for (const auto& [from, to] : head.sides) ++uses[from], ++uses[to];
    add_ends(uses);
  }
  return corners;
}

std::vector<bool> mark(const std::vector<double>& parts, double fewest, double most) {
  constexpr double refined = 0.8;  ///< fraction of the gap in the marked triangles
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return parts[a] > parts[b]; });
  const double all = std::accumulate(parts.begin(), parts.end(), 0.0);
  std::vector<bool> marked(parts.size(), false);
  double sum = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double fraction = static_cast<double>(i) / static_cast<double>(order.size());
    if ((sum > refined * all && fraction > fewest) || fraction > most) break;
    sum += parts[order[i]];
    marked[order[i]] = true;
  }
  return marked;
}

std::vector<bool> mark_inside(const Problem& before, const std::vector<bool>& marked, const Problem& finer) {
  const auto is_inside = [&](std::size_t e, const Vec<2>& x) {
    const Triangle& t = before.triangles[e];
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec<2>&a = before.nodes[static_cast<std::size_t>(t[i])],
            &b = before.nodes[static_cast<std::size_t>(t[(i + 1) % 3])];
      if ((b[0] - a[0]) * (x[1] - a[1]) < (b[1] - a[1]) * (x[0] - a[0])) return false;
    }
    return true;
  };
  std::vector<bool> inside(finer.size(), false);
  for (std::size_t e = 0; e < finer.size(); ++e) {
    Vec<2> centre{};
    for (const int n : finer.triangles[e])
      for (std::size_t d = 0; d < 2; ++d) centre[d] += finer.nodes[static_cast<std::size_t>(n)][d] / 3;
    for (std::size_t k = 0; k < before.size() && !inside[e]; ++k) inside[e] = marked[k] && is_inside(k, centre);
  }
  return inside;
}

}  // namespace talus::bounds
