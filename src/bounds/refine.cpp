// SPDX-License-Identifier: MIT
// Bisection of longest edges, and the corners of the border where stress may jump.
#include "bounds/refine.hpp"

#include <algorithm>
#include <cmath>

#include "bounds/problem.hpp"

namespace talus::bounds {

namespace {

using Key = EdgeKey;

double find_angle(const Problem& problem, const Triangle& t, std::size_t i) {
  const auto get = [&](std::size_t k) -> const Vec<2>& { return problem.nodes[static_cast<std::size_t>(t[k % 3])]; };
  const double ax = get(i + 1)[0] - get(i)[0], ay = get(i + 1)[1] - get(i)[1], bx = get(i + 2)[0] - get(i)[0],
               by = get(i + 2)[1] - get(i)[1];
  return std::atan2(ax * by - ay * bx, ax * bx + ay * by);
}

class Refiner {
 public:
  explicit Refiner(const Problem& problem) : from_(problem), to_(problem) {}

  void mark(const Key& edge) { middles_[edge] = -1; }
  bool has_marked() const { return !middles_.empty(); }

  /// Returns the longest edge; of equal ones that with the smallest node numbers, so that both triangles of an edge
  /// choose alike.
  Key find_longest(const Triangle& t) const {
    Key longest{-1, -1};
    double length = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec<2>&a = get(t[i]), &b = get(t[(i + 1) % 3]);
      const double own = std::hypot(b[0] - a[0], b[1] - a[1]);
      const Key key = make_key(t[i], t[(i + 1) % 3]);
      if (own > length * (1 + 1e-12) || (own > length * (1 - 1e-12) && key < longest))
        length = std::max(own, length), longest = key;
    }
    return longest;
  }

  /// `keeps_shape`: a triangle with a bisected edge has its longest edge bisected too, so that no angle becomes small.
  Problem run(bool keeps_shape) {
    for (bool grows = keeps_shape; grows;) {
      grows = false;
      for (const Triangle& t : from_.triangles) {
        const bool touched = middles_.count(make_key(t[0], t[1])) || middles_.count(make_key(t[1], t[2])) ||
                             middles_.count(make_key(t[2], t[0]));
        if (touched && middles_.try_emplace(find_longest(t), -1).second) grows = true;
      }
    }
    for (auto& [key, node] : middles_) {
      node = static_cast<int>(to_.nodes.size());
      to_.nodes.push_back(halve(get(key.first), get(key.second)));
    }
    to_.triangles.clear(), to_.region.clear(), to_.strength.clear(), to_.body_force.clear(), to_.pore_pressure.clear();
    for (std::size_t e = 0; e < from_.size(); ++e) {
      parent_ = e;
      split(from_.triangles[e], {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    }
    to_.sides.clear();
    for (const Side& s : from_.sides) {
      const auto found = middles_.find(make_key(s.from, s.to));
      if (found == middles_.end()) {
        to_.sides.push_back(s);
        continue;
      }
      const Vec<2> middle = halve(s.traction[0], s.traction[1]);
      Side first = s, second = s;
      first.to = second.from = found->second;
      first.traction[1] = second.traction[0] = middle;
      to_.sides.push_back(first), to_.sides.push_back(second);
    }
    split_bars();
    split_walls();
    return std::move(to_);
  }

 private:
  void split_bars() {
    to_.bars.clear();
    for (const BarEdge& bar : from_.bars) {
      const auto found = middles_.find(make_key(bar.from, bar.to));
      BarEdge first = bar, second = bar;
      if (found != middles_.end()) {
        first.to = second.from = found->second;
        first.force[1] = second.force[0] = 0.5 * (bar.force[0] + bar.force[1]);
        to_.bars.push_back(first);
      }
      to_.bars.push_back(second);
    }
    for (BarHead& head : to_.heads) {
      std::vector<std::array<int, 2>> sides;
      for (const auto& [from, to] : head.sides) {
        const auto found = middles_.find(make_key(from, to));
        if (found != middles_.end()) sides.push_back({from, found->second});
        sides.push_back({found != middles_.end() ? found->second : from, to});
      }
      head.sides = std::move(sides);
    }
  }

  void split_walls() {
    for (Wall& wall : to_.walls) {
      std::vector<int> nodes{wall.nodes.front()};
      std::vector<std::array<InterfaceStrength, 2>> interface;
      for (std::size_t i = 0; i < wall.size(); ++i) {
        const auto found = middles_.find(make_key(wall.nodes[i], wall.nodes[i + 1]));
        for (const int node : {found != middles_.end() ? found->second : -1, wall.nodes[i + 1]}) {
          if (node < 0) continue;
          nodes.push_back(node);
          interface.push_back(wall.interface[i]);
        }
      }
      wall.nodes = std::move(nodes), wall.interface = std::move(interface);
    }
  }

  using Weights = std::array<std::array<double, 3>, 3>;  ///< per corner: its barycentric coordinates in the parent
  static Vec<2> halve(const Vec<2>& a, const Vec<2>& b) { return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}; }
  const Vec<2>& get(int node) const { return to_.nodes[static_cast<std::size_t>(node)]; }

  /// Bisects the longest of the marked edges, recursively.
  void split(const Triangle& t, const Weights& w) {
    std::size_t side = 3;
    double length = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!middles_.count(make_key(t[i], t[(i + 1) % 3]))) continue;
      const Vec<2>&a = get(t[i]), &b = get(t[(i + 1) % 3]);
      const double own = std::hypot(b[0] - a[0], b[1] - a[1]);
      const bool is_longest = make_key(t[i], t[(i + 1) % 3]) == find_longest(t);
      if (is_longest || own > length) length = is_longest ? 1e300 : own, side = i;
    }
    if (side == 3) {
      to_.triangles.push_back(t);
      to_.region.push_back(from_.region[parent_]);
      to_.body_force.push_back(from_.body_force[parent_]);
      std::array<Strength, 3> strength;
      std::array<double, 3> pore{};
      for (std::size_t i = 0; i < 3; ++i) {
        Strength s = from_.strength[parent_][0];
        s.cohesion = 0, s.tan_friction = 0;
        if (s.tension) s.tension = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
          const Strength& own = from_.strength[parent_][k];
          s.cohesion += w[i][k] * own.cohesion, s.tan_friction += w[i][k] * own.tan_friction;
          if (s.tension) *s.tension += w[i][k] * *own.tension;
          pore[i] += w[i][k] * from_.pore_pressure[parent_][k];
        }
        strength[i] = s;
      }
      to_.strength.push_back(strength), to_.pore_pressure.push_back(pore);
      return;
    }
    const std::size_t a = side, b = (side + 1) % 3, c = (side + 2) % 3;
    const int middle = middles_.at(make_key(t[a], t[b]));
    std::array<double, 3> half{};
    for (std::size_t k = 0; k < 3; ++k) half[k] = 0.5 * (w[a][k] + w[b][k]);
    split({t[a], middle, t[c]}, {w[a], half, w[c]});
    split({middle, t[b], t[c]}, {half, w[b], w[c]});
  }

  const Problem& from_;
  Problem to_;
  std::map<Key, int> middles_;
  std::size_t parent_ = 0;
};

}  // namespace

Problem refine(const Problem& problem, const std::vector<bool>& marked) {
  Refiner refiner(problem);
  for (std::size_t e = 0; e < problem.size(); ++e)
    if (marked[e]) refiner.mark(refiner.find_longest(problem.triangles[e]));
  return refiner.run(true);
}

Problem fan_out(const Problem& problem, const std::vector<int>& nodes, double widest) {
  Problem finer = problem;
  for (;;) {
    Refiner refiner(finer);
    for (const Triangle& t : finer.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        if (std::find(nodes.begin(), nodes.end(), t[i]) != nodes.end() && find_angle(finer, t, i) > widest)
          refiner.mark(make_key(t[(i + 1) % 3], t[(i + 2) % 3]));
    if (!refiner.has_marked()) return finer;
    finer = refiner.run(false);
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

}  // namespace talus::bounds
