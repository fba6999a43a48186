// SPDX-License-Identifier: MIT
// Sections of limit analysis: columns of crossed triangles.

#include "support/bounds_sections.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include "bounds/problem.hpp"

namespace talus::bounds {

Problem make_columns(const std::vector<double>& x, int rows, double base, const std::function<double(double)>& ground) {
  Problem p;
  const int n = static_cast<int>(x.size());
  for (int j = 0; j <= rows; ++j)
    for (const double at : x) p.nodes.push_back({at, base + (ground(at) - base) * j / rows});
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < n - 1; ++i) {
      const int a = j * n + i, b = a + 1, c = a + n, d = c + 1, middle = static_cast<int>(p.nodes.size());
      Vec<2> centre{0, 0};
      for (const int k : {a, b, c, d})
        for (std::size_t q = 0; q < 2; ++q) centre[q] += 0.25 * p.nodes[static_cast<std::size_t>(k)][q];
      p.nodes.push_back(centre);
      for (const Triangle& t : {Triangle{a, b, middle}, {b, d, middle}, {d, c, middle}, {c, a, middle}})
        p.triangles.push_back(t);
    }
  for (int i = 0; i < n - 1; ++i) p.sides.push_back({i, i + 1, true, true, {}});
  for (int j = 0; j < rows; ++j) {
    p.sides.push_back({(j + 1) * n, j * n, true, false, {}});
    p.sides.push_back({j * n + n - 1, (j + 1) * n + n - 1, true, false, {}});
  }
  return p;
}

Problem keep_part(const Problem& whole, const std::function<bool(const Vec<2>&)>& is_kept) {
  Problem part;
  part.nodes = whole.nodes;
  for (const Triangle& t : whole.triangles) {
    Vec<2> centre{0, 0};
    for (const int n : t)
      for (std::size_t d = 0; d < 2; ++d) centre[d] += whole.nodes[static_cast<std::size_t>(n)][d] / 3;
    if (is_kept(centre)) part.triangles.push_back(t);
  }
  std::set<EdgeKey> edges;
  for (const Edge& edge : list_edges(part.triangles)) edges.insert(make_key(edge.from, edge.to));
  for (const Side& s : whole.sides)
    if (edges.contains(make_key(s.from, s.to))) part.sides.push_back(s);
  return part;
}

void fill(Problem& problem, double cohesion, double friction_degrees, double unit_weight) {
  const Strength soil{cohesion, std::tan(friction_degrees * std::numbers::pi / 180), {}};
  problem.strength.assign(problem.size(), {soil, soil, soil});
  problem.body_force.assign(problem.size(), {0, -unit_weight});
  problem.pore_pressure.assign(problem.size(), {0, 0, 0});
  problem.region.assign(problem.size(), 0);
}

std::vector<double> divide(double from, const std::vector<std::pair<double, int>>& pieces) {
  std::vector<double> x{from};
  for (const auto& [to, parts] : pieces) {
    const double begin = x.back();
    for (int i = 1; i <= parts; ++i) x.push_back(begin + (to - begin) * i / parts);
  }
  return x;
}

void press(Problem& problem, double from, double to, double level, double pressure) {
  for (const Edge& edge : list_edges(problem.triangles)) {
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(edge.from)],
          &b = problem.nodes[static_cast<std::size_t>(edge.to)];
    const double x = 0.5 * (a[0] + b[0]), y = 0.5 * (a[1] + b[1]);
    if (edge.other < 0 && x > from && x < to && std::abs(y - level) < 1e-9)
      problem.sides.push_back({edge.from, edge.to, false, false, {{{0, -pressure}, {0, -pressure}}}});
  }
}

}  // namespace talus::bounds
