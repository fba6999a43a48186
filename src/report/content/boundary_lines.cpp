// SPDX-License-Identifier: MIT
#include "report/content/boundary_lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "input/echo.hpp"
#include "mesh/planar.hpp"

namespace talus::report {
namespace {

/// Points nearer to the straight line between their neighbours than this share of the line's extent lie on it.
constexpr double straight = 1e-9;

}  // namespace

std::vector<Polyline> join_sides(const mesh::Mesh<2>& mesh, const std::vector<mesh::Mesh<2>::Side>& sides) {
  std::map<int, std::vector<int>> beside;
  for (const auto& side : sides) {
    beside[side[0]].push_back(side[1]);
    beside[side[1]].push_back(side[0]);
  }
  std::set<std::pair<int, int>> used;
  std::vector<Polyline> lines;
  const auto walk = [&](int start) {
    Polyline line{mesh.nodes[static_cast<std::size_t>(start)]};
    for (int at = start;;) {
      const std::vector<int>& next = beside.at(at);
      const auto step = std::find_if(next.begin(), next.end(), [&](int n) {
        return !used.contains({std::min(at, n), std::max(at, n)});
      });
      if (step == next.end()) break;
      used.insert({std::min(at, *step), std::max(at, *step)});
      at = *step;
      line.push_back(mesh.nodes[static_cast<std::size_t>(at)]);
    }
    if (line.size() < 2) return;
    double length = 0;
    for (const auto& x : line) length = std::max(length, std::hypot(x[0] - line[0][0], x[1] - line[0][1]));
    lines.push_back(mesh::drop_straight_points(line, false, straight * length));
  };
  // Ends and forks first, so that no line begins in its middle; what is left is closed.
  for (const auto& [node, others] : beside)
    if (others.size() != 2)
      for (std::size_t k = 0; k < others.size(); ++k) walk(node);
  for (const auto& [node, others] : beside) walk(node);
  return lines;
}

std::vector<Polyline> find_boundary_lines(const std::string& name, const mesh::Plan& plan,
                                          const std::optional<mesh::Mesh<2>>& mesh) {
  if (mesh) {
    const auto sides = mesh->sides.find(name);
    return sides == mesh->sides.end() ? std::vector<Polyline>{} : join_sides(*mesh, sides->second);
  }
  for (const mesh::Line& line : plan.lines)
    if (line.name == name) return {line.points};
  const auto [x0, y0] = plan.box_min;
  const auto [x1, y1] = plan.box_max;
  if (plan.box_min == plan.box_max) return {};  // a ready mesh
  if (name == "left") return {{{x0, y0}, {x0, y1}}};
  if (name == "right") return {{{x1, y0}, {x1, y1}}};
  if (name == "bottom") return {{{x0, y0}, {x1, y0}}};
  if (name == "top") return {{{x0, y1}, {x1, y1}}};
  return {};
}

}  // namespace talus::report
