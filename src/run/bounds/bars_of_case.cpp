// SPDX-License-Identifier: MIT
#include "run/bounds/bars_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "run/common/section_of_case.hpp"
#include "run/common/walls_of_case.hpp"
#include "site/mesh_sides.hpp"

namespace talus::run {
namespace {

/// Half the width of the ground on which the head of a bar presses [m].
constexpr double half_width = 0.5;
/// Parts of a bar in which its force is examined for kinks; kinks nearer than this fraction are one.
constexpr int samples = 400;
constexpr double near = 1e-3;

}  // namespace

std::array<double, 3> BarsOfCase::Line::list_limits(double s) const {
  const double strength = bar.is_active && bar.prestress > 0 ? std::min(bar.tensile, bar.prestress) : bar.tensile;
  return {strength, bar.plate + diagram.find_part(0, s), diagram.find_part(s, length)};
}

double BarsOfCase::Line::find_force(double s) const {
  const auto limits = list_limits(s);
  return std::max(0.0, *std::min_element(limits.begin(), limits.end()));
}

BarsOfCase::BarsOfCase(const site::Site& site) {
  if (site.data().supports.empty()) return;
  const lem::Slope slope(make_section(site).section);
  const std::vector<WallLine> walls = list_walls(site);
  for (lem::Bar bar : slope.section().bars) {
    if (site.data().supports.at(bar.name).kind == input::SupportKind::wall) continue;
    const auto wall = find_wall(site, walls, bar.head);
    if (wall) bar.head = find_nearest(walls[*wall].points, bar.head);
    Line line{bar, lem::make_bar_diagram(slope, bar), fmt::format("support {} {}", bar.name, lines_.size() + 1), 0, {},
              wall};
    const double dx = bar.end[0] - bar.head[0], dy = bar.end[1] - bar.head[1];
    line.length = std::hypot(dx, dy);
    line.direction = {dx / line.length, dy / line.length};
    lines_.push_back(std::move(line));
  }
}

std::vector<double> BarsOfCase::list_kinks(const Line& line) const {
  const auto find_governing = [&](double s) {
    const auto limits = line.list_limits(s);
    return std::min_element(limits.begin(), limits.end()) - limits.begin();
  };
  std::vector<double> kinks{0};
  const auto add = [&](double s) {
    if (s - kinks.back() > near * line.length && line.length - s > near * line.length) kinks.push_back(s);
  };
  bool is_free = line.bar.free_length > 0;
  for (int i = 1; i <= samples; ++i) {
    double a = line.length * (i - 1) / samples, b = line.length * i / samples;
    if (is_free && b >= line.bar.free_length) is_free = false, add(line.bar.free_length);
    const auto first = find_governing(a);
    if (first == find_governing(b)) continue;
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (a + b);
      (find_governing(middle) == first ? a : b) = middle;
    }
    add(b);
  }
  kinks.push_back(line.length);
  return kinks;
}

mesh::Plan BarsOfCase::conform(mesh::Plan plan) const {
  for (const Line& line : lines_) {
    mesh::Line& added = plan.lines.emplace_back();
    added.name = line.name;
    for (const double s : list_kinks(line)) added.points.push_back(line.at(s));
    added.points.back() = line.bar.end;
  }
  return plan;
}

bounds::BarHead BarsOfCase::make_head(const Line& line, int node, const bounds::Problem& problem) const {
  bounds::BarHead head{node, line.direction, line.find_force(0), !line.bar.is_active, {}, line.wall};
  if (line.wall) return head;
  const bounds::WallKeys walls(problem);
  for (const bounds::Edge& edge : bounds::list_edges(problem.triangles)) {
    if (edge.other >= 0 || walls.contains(edge.from, edge.to)) continue;
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(edge.from)],
          &b = problem.nodes[static_cast<std::size_t>(edge.to)];
    const double x = 0.5 * (a[0] + b[0]) - line.bar.head[0], y = 0.5 * (a[1] + b[1]) - line.bar.head[1];
    if (edge.from == node || edge.to == node || std::hypot(x, y) < half_width)
      head.sides.push_back({edge.from, edge.to});
  }
  return head;
}

void BarsOfCase::add(const mesh::Mesh<2>& mesh, const std::vector<int>& number, bounds::Problem& problem) const {
  const bounds::WallKeys walls(problem);
  for (std::size_t bar = 0; bar < lines_.size(); ++bar) {
    const Line& line = lines_[bar];
    const auto measure = [&](int node) {
      const Vec<2>& x = problem.nodes[static_cast<std::size_t>(node)];
      return (x[0] - line.bar.head[0]) * line.direction[0] + (x[1] - line.bar.head[1]) * line.direction[1];
    };
    int first = -1;
    double nearest = std::numeric_limits<double>::infinity();
    const std::size_t begin = problem.bars.size();
    for (const auto& side : site::find_sides(mesh, line.name)) {
      int from = number[static_cast<std::size_t>(side[0])], to = number[static_cast<std::size_t>(side[1])];
      if (from < 0 || to < 0) continue;
      if (measure(from) > measure(to)) std::swap(from, to);
      if (walls.contains(from, to))
        throw Error(
            ExitCode::wrong_input,
            fmt::format("a bar of support '{}' lies along a wall, which limit analysis does not take", line.bar.name));
      problem.bars.push_back(
          {from, to, {line.find_force(measure(from)), line.find_force(measure(to))}, !line.bar.is_active, bar});
      if (measure(from) < nearest) nearest = measure(from), first = from;
    }
    if (first < 0 || !(line.find_force(0) > 0)) continue;
    bounds::BarHead head = make_head(line, first, problem);
    head.bar = bar;
    const bool is_held = head.wall || std::any_of(head.sides.begin(), head.sides.end(),
                                                  [&](const auto& s) { return s[0] == first || s[1] == first; });
    if (is_held) {
      problem.heads.push_back(head);
      continue;
    }
    // A buried end has nothing to press on.
    for (std::size_t i = begin; i < problem.bars.size(); ++i)
      if (problem.bars[i].from == first) problem.bars[i].force[0] = 0;
  }
}

}  // namespace talus::run
