// SPDX-License-Identifier: MIT
#include "mesh/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "mesh/planar.hpp"

namespace talus::mesh {

namespace {

/// Significant digits of numbers of the case in messages; further ones are rounding errors of a conversion.
constexpr int given_digits = 15;

/// Formats a length of the case as it was given, in the units of display.
std::string write(double length, const Plan& plan) {
  return format_value(length, plan.units.length, given_digits);
}

std::string write(const Point2& x, const Plan& plan) {
  const double si = plan.units.length.si;
  return fmt::format("({:.{}g}, {:.{}g})", x[0] / si, given_digits, x[1] / si, given_digits);
}

void check_numbers(const Plan& plan) {
  const auto finite = [](const Point2& x) { return std::isfinite(x[0]) && std::isfinite(x[1]); };
  if (plan.dimension != 2 && plan.dimension != 3) fail_input("mesh dimension {} is neither 2 nor 3", plan.dimension);
  if (!finite(plan.box_min) || !finite(plan.box_max) || !(plan.box_min[0] < plan.box_max[0]) ||
      !(plan.box_min[1] < plan.box_max[1]))
    fail_input("the box from {} to {} {} has no area: its second corner must lie right of and above the first",
               write(plan.box_min, plan), write(plan.box_max, plan), plan.units.length.name);
  if (!(plan.size > 0) || !std::isfinite(plan.size))
    fail_input("element size {} must be positive", write(plan.size, plan));
  if (plan.dimension == 3 && (!(plan.thickness > 0) || !std::isfinite(plan.thickness)))
    fail_input("thickness {} must be positive in 3D", write(plan.thickness, plan));
  for (const Refinement& r : plan.refinements) {
    if (r.near.empty()) fail_input("a refinement has no place: give one point or a polyline");
    if (!(r.size > 0) || !(r.distance > 0))
      fail_input("the refinement near {} needs a positive size and distance, not {} and {}", write(r.near[0], plan),
                 write(r.size, plan), write(r.distance, plan));
  }
  for (const Polygon& p : plan.polygons)
    if (!std::all_of(p.points.begin(), p.points.end(), finite))
      fail_input("polygon '{}' has a point that is not finite", p.name);
  for (const Line& l : plan.lines)
    if (!std::all_of(l.points.begin(), l.points.end(), finite))
      fail_input("line '{}' has a point that is not finite", l.name);
}

void check_names(const Plan& plan) {
  std::set<std::string_view> regions, sides{"left", "right", "bottom", "top"};
  if (plan.dimension == 3) sides.insert({"front", "back"});
  for (const Polygon& p : plan.polygons) {
    if (p.name.empty()) fail_input("a soil polygon has no name");
    if (p.name == "empty")
      fail_input("a soil polygon cannot be named 'empty': that is the part of the box without soil");
    if (!regions.insert(p.name).second) fail_input("two soil polygons are named '{}': each needs its own name", p.name);
  }
  for (const Line& l : plan.lines) {
    if (l.name.empty()) fail_input("a line of the mesh has no name");
    if (!sides.insert(l.name).second)
      fail_input("the name '{}' of a line is taken: by another line or by a side of the box", l.name);
  }
}

/// Moves `x` onto the box's sides and onto earlier points within the tolerance.
Point2 snap(Point2 x, const Plan& plan, Polyline& known, double tolerance) {
  for (int d = 0; d < 2; ++d)
    for (double wall : {plan.box_min[d], plan.box_max[d]})
      if (std::abs(x[d] - wall) <= tolerance) x[d] = wall;
  for (const Point2& k : known)
    if (std::hypot(x[0] - k[0], x[1] - k[1]) <= tolerance) return k;
  known.push_back(x);
  return x;
}

void check_polygon(const Polygon& polygon, const Plan& plan, double tolerance) {
  const auto& points = polygon.points;
  if (points.size() < 3) fail_input("polygon '{}' has {} points: at least 3 are needed", polygon.name, points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i] == points[(i + 1) % points.size()])
      fail_input("polygon '{}' has the point {} twice in a row; the first point is not repeated at the end",
                 polygon.name, write(points[i], plan));
  if (const auto place = find_self_contact(points, tolerance))
    fail_input("polygon '{}' crosses or touches itself at {}", polygon.name, format_point(*place, plan.units.length));
}

void check_line(const Line& line, const Plan& plan) {
  if (line.points.size() < 2)
    fail_input("line '{}' has {} points: at least 2 are needed", line.name, line.points.size());
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
    if (line.points[i] == line.points[i + 1])
      fail_input("line '{}' has the point {} twice in a row", line.name, write(line.points[i], plan));
}

void check_within_box(std::string_view what, const std::string& name, const Polyline& points, const Plan& plan) {
  for (const Point2& x : points)
    for (int d = 0; d < 2; ++d)
      if (x[d] < plan.box_min[d] || x[d] > plan.box_max[d])
        fail_input("{} '{}' leaves the box at {}: the box reaches from {} to {} {}", what, name, write(x, plan),
                   write(plan.box_min, plan), write(plan.box_max, plan), plan.units.length.name);
}

}  // namespace

Plan check_plan(const Plan& given) {
  check_numbers(given);
  check_names(given);
  Plan plan = given;
  const double tolerance = get_tolerance(plan);
  Polyline known{plan.box_min, {plan.box_max[0], plan.box_min[1]}, plan.box_max, {plan.box_min[0], plan.box_max[1]}};
  for (Polygon& p : plan.polygons)
    for (Point2& x : p.points) x = snap(x, plan, known, tolerance);
  for (Line& l : plan.lines)
    for (Point2& x : l.points) x = snap(x, plan, known, tolerance);

  for (const Polygon& p : plan.polygons) {
    check_polygon(p, plan, tolerance);
    check_within_box("polygon", p.name, p.points, plan);
  }
  for (const Line& l : plan.lines) {
    check_line(l, plan);
    check_within_box("line", l.name, l.points, plan);
  }
  for (std::size_t j = 0; j < plan.polygons.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const Relation relation = compare(plan.polygons[i].points, plan.polygons[j].points, tolerance);
      if (relation == Relation::same)
        fail_input("polygons '{}' and '{}' are the same", plan.polygons[i].name, plan.polygons[j].name);
      if (relation == Relation::overlapping)
        fail_input(
            "polygons '{}' and '{}' overlap partly: polygons may share edges, or one may lie wholly inside another",
            plan.polygons[i].name, plan.polygons[j].name);
    }
  return plan;
}

Plan resize(Plan plan, double size) {
  const double finer = plan.size > 0 ? size / plan.size : 1;
  plan.size = size;
  for (Refinement& r : plan.refinements) r.size *= finer;
  return plan;
}

}  // namespace talus::mesh
