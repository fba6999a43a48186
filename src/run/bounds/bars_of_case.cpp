// SPDX-License-Identifier: MIT
#include "run/bounds/bars_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/error.hpp"
#include "input/case/support.hpp"
#include "run/common/section_of_case.hpp"
#include "run/common/walls_of_case.hpp"
#include "site/ground_load.hpp"
#include "site/mesh_sides.hpp"

namespace talus::run {
namespace {

/// Half the width of the ground on which the head of a bar presses [m]. Its ends are corners of the mesh, unless
/// another corner or head lies nearer than `same_end` [m], so that the width does not depend on the size of the
/// triangles.
constexpr double half_width = 0.5, same_end = 0.01;
/// Distance from the ground up to which a point lies on it [m].
constexpr double on_ground = 1e-4;
/// Parts of a bar in which its force is examined for kinks; kinks nearer than this fraction are one.
constexpr int bar_samples = 400;
constexpr double near = 1e-3;

/// Points of an edge between its nodes at which its force is held against that of the bar, and differences up to this
/// fraction of it that are rounding errors.
constexpr int edge_samples = 9;
constexpr double rounding_of_force = 1e-6;
/// Distance from the end of a bar, over its length, up to which a node is that end.
constexpr double at_end_of_bar = 1e-6;

double find_part(int sample) {
  return (sample + 1.0) / (edge_samples + 1);
}

/// The point of a line that is nearest to another point.
struct Foot {
  double along = 0;                                      ///< from the start of the line [m]
  double off = std::numeric_limits<double>::infinity();  ///< distance to it [m]
};

Foot find_foot(const site::Polyline& line, const Vec<2>& x) {
  Foot foot;
  double start = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double dx = line[i + 1][0] - line[i][0], dy = line[i + 1][1] - line[i][1], length = std::hypot(dx, dy);
    if (!(length > 0)) continue;
    const double s = std::clamp(((x[0] - line[i][0]) * dx + (x[1] - line[i][1]) * dy) / length, 0.0, length),
                 off = std::hypot(line[i][0] + s / length * dx - x[0], line[i][1] + s / length * dy - x[1]);
    if (off < foot.off) foot = {start + s, off};
    start += length;
  }
  return foot;
}

/// Returns the point at this distance from the start of a line; nothing beyond its ends.
std::optional<site::Point> find_place(const site::Polyline& line, double along) {
  for (std::size_t i = 0; along >= 0 && i + 1 < line.size(); ++i) {
    const double dx = line[i + 1][0] - line[i][0], dy = line[i + 1][1] - line[i][1], length = std::hypot(dx, dy);
    if (length > 0 && along <= length)
      return site::Point{line[i][0] + along / length * dx, line[i][1] + along / length * dy};
    along -= length;
  }
  return std::nullopt;
}

}  // namespace

std::array<double, 3> BarsOfCase::Line::list_limits(double s) const {
  return {bar.tensile, bar.plate + diagram.find_part(0, s), diagram.find_part(s, length)};
}

double BarsOfCase::Line::find_force(double s) const {
  const auto limits = list_limits(s);
  return std::max(0.0, *std::min_element(limits.begin(), limits.end()));
}

BarsOfCase::BarsOfCase(const site::Site& site) {
  if (site.data().supports.empty()) return;
  ground_ = site.ground();
  const lem::Slope slope(make_section(site).section);
  const std::vector<WallLine> walls = list_walls(site);
  for (lem::Bar bar : slope.section().bars) {
    if (site.data().supports.at(bar.name).kind == input::SupportKind::wall) continue;
    const auto wall = find_wall(site, walls, bar.head);
    if (wall)
      bar.head = find_nearest(walls[*wall].points, bar.head);
    else if (const Foot foot = find_foot(ground_, bar.head); foot.off <= on_ground)
      // A head beside the ground by rounding of its coordinates would leave a triangle without area.
      bar.head = find_place(ground_, foot.along).value_or(bar.head);
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
    // A force that grows within less than that from an end does so over that length: a line from the end to the next
    // node of the mesh would be far from it.
    s = std::clamp(s, near * line.length, (1 - near) * line.length);
    if (s - kinks.back() > 0.5 * near * line.length) kinks.push_back(s);
  };
  bool is_free = line.bar.free_length > 0;
  for (int i = 1; i <= bar_samples; ++i) {
    double a = line.length * (i - 1) / bar_samples, b = line.length * i / bar_samples;
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

std::vector<site::Point> BarsOfCase::list_head_ends() const {
  std::vector<site::Point> ends;
  for (const Line& line : lines_) {
    const Foot foot = find_foot(ground_, line.bar.head);
    if (line.wall || foot.off > on_ground || !(line.find_force(0) > 0)) continue;
    for (const double side : {-half_width, half_width}) {
      const auto end = find_place(ground_, foot.along + side);
      const bool is_at_head =
          end && std::any_of(lines_.begin(), lines_.end(), [&](const Line& other) {
            return std::hypot(other.bar.head[0] - (*end)[0], other.bar.head[1] - (*end)[1]) < same_end;
          });
      if (end && !is_at_head) ends.push_back(*end);
    }
  }
  return ends;
}

mesh::Plan BarsOfCase::conform(mesh::Plan plan) const {
  if (plan.file.empty()) plan = site::add_corners(std::move(plan), list_head_ends(), same_end);
  for (const Line& line : lines_) {
    mesh::Line& added = plan.lines.emplace_back();
    added.name = line.name;
    for (const double s : list_kinks(line)) added.points.push_back(line.at(s));
    added.points.back() = line.bar.end;
  }
  return plan;
}

double BarsOfCase::measure(const bounds::Problem& problem, std::size_t bar, int node) const {
  const Vec<2>&x = problem.nodes[static_cast<std::size_t>(node)], &head = lines_[bar].bar.head,
        &d = lines_[bar].direction;
  return (x[0] - head[0]) * d[0] + (x[1] - head[1]) * d[1];
}

std::vector<double> BarsOfCase::sample(const bounds::Problem& problem, const bounds::BarEdge& edge) const {
  const double from = measure(problem, edge.bar, edge.from), to = measure(problem, edge.bar, edge.to);
  std::vector<double> forces;
  for (int i = 0; i < edge_samples; ++i)
    forces.push_back(lines_[edge.bar].find_force(from + find_part(i) * (to - from)));
  return forces;
}

bool BarsOfCase::are_bent(const bounds::Problem& problem) const {
  return std::any_of(problem.bars.begin(), problem.bars.end(), [&](const bounds::BarEdge& edge) {
    const std::vector<double> forces = sample(problem, edge);
    const double largest = *std::max_element(forces.begin(), forces.end());
    for (int i = 0; i < edge_samples; ++i) {
      const double chord = edge.force[0] + find_part(i) * (edge.force[1] - edge.force[0]);
      if (std::abs(chord - forces[static_cast<std::size_t>(i)]) > rounding_of_force * largest) return true;
    }
    return false;
  });
}

void BarsOfCase::enclose(bounds::Problem& problem, bounds::Bound bound) const {
  const bool is_lower = bound == bounds::Bound::lower;
  using Place = std::pair<std::size_t, int>;  // bar and node
  // An end in the soil has no force: a jump there would be a force on the soil.
  std::set<Place> ends, held;
  for (const bounds::BarEdge& edge : problem.bars) held.insert({edge.bar, edge.to});
  for (const bounds::BarHead& head : problem.heads) held.insert({head.bar, head.node});
  for (const bounds::BarEdge& edge : problem.bars) {
    if (!held.contains({edge.bar, edge.from})) ends.insert({edge.bar, edge.from});
    if (measure(problem, edge.bar, edge.to) > (1 - at_end_of_bar) * lines_[edge.bar].length)
      ends.insert({edge.bar, edge.to});
  }
  std::map<Place, double> at_node;
  const auto find = [&](const bounds::BarEdge& edge, bool at_end) -> double& {
    return at_node[{edge.bar, at_end ? edge.to : edge.from}];
  };
  for (const bounds::BarEdge& edge : problem.bars)
    for (const int node : {edge.from, edge.to})
      at_node[{edge.bar, node}] =
          ends.contains({edge.bar, node}) ? 0 : lines_[edge.bar].find_force(measure(problem, edge.bar, node));
  const auto exact = at_node;
  for (const bounds::BarEdge& edge : problem.bars) {
    const std::vector<double> forces = sample(problem, edge);
    const double from = exact.at({edge.bar, edge.from}), to = exact.at({edge.bar, edge.to});
    double off = 0;  // by which the chord is on the wrong side
    for (int i = 0; i < edge_samples; ++i) {
      const double chord = from + find_part(i) * (to - from), force = forces[static_cast<std::size_t>(i)];
      off = std::max(off, is_lower ? chord - force : force - chord);
    }
    for (const bool at_end : {false, true}) {
      double& own = find(edge, at_end);
      const double known = at_end ? to : from;
      if (known > 0) own = is_lower ? std::max(0.0, std::min(own, known - off)) : std::max(own, known + off);
    }
  }
  // Next to a force of zero the other end alone decides.
  for (const bounds::BarEdge& edge : problem.bars) {
    const std::vector<double> forces = sample(problem, edge);
    for (const bool at_end : {true, false}) {
      double& own = find(edge, at_end);
      const double other = find(edge, !at_end);
      if (own == 0 || other != 0) continue;
      for (int i = 0; i < edge_samples; ++i) {
        const double part = at_end ? find_part(i) : 1 - find_part(i),
                     needed = forces[static_cast<std::size_t>(i)] / part;
        own = is_lower ? std::min(own, needed) : std::max(own, needed);
      }
    }
  }
  for (bounds::BarEdge& edge : problem.bars) edge.force = {find(edge, false), find(edge, true)};
  for (bounds::BarHead& head : problem.heads) head.force = at_node.at({head.bar, head.node});
}

bounds::BarHead BarsOfCase::make_head(const Line& line, int node, const bounds::Problem& problem) const {
  bounds::BarHead head{node, line.direction, line.find_force(0), !line.bar.is_active, {}, line.wall};
  if (line.wall) return head;
  const bounds::WallKeys walls(problem);
  const double at = find_foot(ground_, line.bar.head).along;
  for (const bounds::Edge& edge : bounds::list_edges(problem.triangles)) {
    if (edge.other >= 0 || walls.contains(edge.from, edge.to)) continue;
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(edge.from)],
          &b = problem.nodes[static_cast<std::size_t>(edge.to)];
    const Foot middle = find_foot(ground_, {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])});
    if (middle.off < on_ground && std::abs(middle.along - at) < half_width) head.sides.push_back({edge.from, edge.to});
  }
  return head;
}

void BarsOfCase::add(const mesh::Mesh<2>& mesh, const std::vector<int>& number, bounds::Problem& problem) const {
  const bounds::WallKeys walls(problem);
  for (std::size_t bar = 0; bar < lines_.size(); ++bar) {
    const Line& line = lines_[bar];
    const auto find_place = [&](int node) { return measure(problem, bar, node); };
    int first = -1;
    double nearest = std::numeric_limits<double>::infinity();
    const std::size_t begin = problem.bars.size();
    for (const auto& side : site::find_sides(mesh, line.name)) {
      int from = number[static_cast<std::size_t>(side[0])], to = number[static_cast<std::size_t>(side[1])];
      if (from < 0 || to < 0) continue;
      if (find_place(from) > find_place(to)) std::swap(from, to);
      if (walls.contains(from, to))
        throw Error(
            ExitCode::wrong_input,
            fmt::format("a bar of support '{}' lies along a wall, which limit analysis does not take", line.bar.name));
      problem.bars.push_back(
          {from, to, {line.find_force(find_place(from)), line.find_force(find_place(to))}, !line.bar.is_active, bar});
      if (find_place(from) < nearest) nearest = find_place(from), first = from;
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
