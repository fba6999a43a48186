// SPDX-License-Identifier: MIT
// Marching through the triangles that the water table crosses.

#include "fem/solid/water_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace talus::fem {

namespace {

using Edge = std::pair<int, int>;
using Point = std::array<double, 2>;

struct Crossings {
  const mesh::Mesh<2>& mesh;
  const std::vector<double>& pressure;

  bool is_wet(int node) const { return pressure[static_cast<std::size_t>(node)] <= 0; }
  Point find_point(const Edge& edge) const {
    const auto a = static_cast<std::size_t>(edge.first), b = static_cast<std::size_t>(edge.second);
    const double t = pressure[a] / (pressure[a] - pressure[b]);
    return {mesh.nodes[a][0] + t * (mesh.nodes[b][0] - mesh.nodes[a][0]),
            mesh.nodes[a][1] + t * (mesh.nodes[b][1] - mesh.nodes[a][1])};
  }
};

void append(std::vector<Point>& line, const Point& p) {
  if (line.empty() || std::hypot(p[0] - line.back()[0], p[1] - line.back()[1]) > 1e-12) line.push_back(p);
}

}  // namespace

std::vector<std::vector<Point>> find_water_table(const mesh::Mesh<2>& mesh, const std::vector<double>& pressure) {
  const Crossings crossings{mesh, pressure};
  std::map<Edge, std::vector<Edge>> next;  // an edge and the one or two that the line goes on to
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    std::vector<Edge> crossed;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = mesh.elements[e][k], b = mesh.elements[e][(k + 1) % 3];
      if (crossings.is_wet(a) != crossings.is_wet(b)) crossed.emplace_back(std::min(a, b), std::max(a, b));
    }
    if (crossed.size() != 2) continue;
    next[crossed[0]].push_back(crossed[1]);
    next[crossed[1]].push_back(crossed[0]);
  }
  std::vector<std::vector<Point>> lines;
  std::map<Edge, bool> used;
  const auto follow = [&](Edge edge) {
    std::vector<Point> line;
    const Edge first = edge;
    for (bool more = true; more;) {
      used[edge] = true;
      append(line, crossings.find_point(edge));
      more = false;
      for (const Edge& other : next[edge]) {
        if (used[other]) continue;
        edge = other;
        more = true;
        break;
      }
    }
    const auto& ends = next[edge];
    if (edge != first && ends.size() == 2 && next[first].size() == 2 &&
        std::find(ends.begin(), ends.end(), first) != ends.end())
      line.push_back(line.front());
    if (line.size() > 1 && line.front()[0] > line.back()[0]) std::reverse(line.begin(), line.end());
    if (line.size() > 1) lines.push_back(line);
  };
  for (const auto& [edge, others] : next) {
    if (others.size() == 1 && !used[edge]) follow(edge);
  }
  for (const auto& [edge, others] : next) {
    if (!used[edge]) follow(edge);
  }
  return lines;
}

}  // namespace talus::fem
