// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/numbers.hpp"
#include "base/user_file.hpp"
#include "input/case/checks.hpp"

namespace talus::input {
namespace {

using Point = std::array<double, 2>;

std::string write_index(const char* list, std::size_t i) {
  return fmt::format("{}.{}", list, i);
}

/// Twice the signed area of the triangle abc [m²].
double measure_turn(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool is_between(const Point& a, const Point& b, const Point& p) {
  return std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) && std::min(a[1], b[1]) <= p[1] &&
         p[1] <= std::max(a[1], b[1]);
}

/// Whether the segments ab and cd have a point in common.
bool do_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double abc = measure_turn(a, b, c), abd = measure_turn(a, b, d);
  const double cda = measure_turn(c, d, a), cdb = measure_turn(c, d, b);
  if (((abc > 0) != (abd > 0)) && ((cda > 0) != (cdb > 0)) && abc != 0 && abd != 0 && cda != 0 && cdb != 0) return true;
  return (abc == 0 && is_between(a, b, c)) || (abd == 0 && is_between(a, b, d)) || (cda == 0 && is_between(c, d, a)) ||
         (cdb == 0 && is_between(c, d, b));
}

void check_inside(const mesh::Plan& plan, const std::vector<Point>& points, const std::string& path,
                  const std::string& what, Findings& findings) {
  // Coordinates that come from other units carry rounding errors; a billionth of the box is far below any element.
  const double slack = 1e-9 * std::max(plan.box_max[0] - plan.box_min[0], plan.box_max[1] - plan.box_min[1]);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    if (p[0] < plan.box_min[0] - slack || p[0] > plan.box_max[0] + slack || p[1] < plan.box_min[1] - slack ||
        p[1] > plan.box_max[1] + slack)
      findings.add(fmt::format("{}.points.{}", path, i),
                   fmt::format("the point {} of {} is outside the box from {} to {}", format_point(p), what,
                               format_point(plan.box_min), format_point(plan.box_max)));
  }
}

void check_polygon(const mesh::Polygon& polygon, const std::string& path, Findings& findings) {
  const std::vector<Point>& p = polygon.points;
  const std::size_t n = p.size();
  if (n < 3)
    return findings.add(path + ".points",
                        fmt::format("polygon '{}' has {} points; it needs at least 3", polygon.name, n));
  for (std::size_t i = 0; i < n; ++i)
    if (p[i] == p[(i + 1) % n])
      return findings.add(fmt::format("{}.points.{}", path, (i + 1) % n),
                          fmt::format("polygon '{}' repeats its point {}; each corner is written once", polygon.name,
                                      format_point(p[i])));
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = p[i], &b = p[(i + 1) % n], &c = p[(i + 2) % n];
    const double forward = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
    if (measure_turn(a, b, c) == 0 && forward < 0)
      return findings.add(
          fmt::format("{}.points.{}", path, (i + 1) % n),
          fmt::format("polygon '{}' crosses itself: it turns back on itself at {}", polygon.name, format_point(b)));
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours share a corner
      if (do_meet(p[i], p[i + 1], p[j], p[(j + 1) % n]))
        return findings.add(
            fmt::format("{}.points.{}", path, j),
            fmt::format("polygon '{}' crosses itself: its side from {} to {} meets that from {} to {}", polygon.name,
                        format_point(p[i]), format_point(p[i + 1]), format_point(p[j]), format_point(p[(j + 1) % n])));
    }
  }
  double area = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) area += measure_turn(p[0], p[i], p[i + 1]);
  if (area == 0) findings.add(path + ".points", fmt::format("polygon '{}' has no area", polygon.name));
}

void check_lines(const Case& data, bool has_box, Findings& findings) {
  std::set<std::string> names{"left", "right", "bottom", "top"};
  if (data.mesh.dimension == 3) names.insert({"front", "back"});
  for (std::size_t i = 0; i < data.mesh.lines.size(); ++i) {
    const std::string path = write_index("geometry.line", i);
    const mesh::Line& line = data.mesh.lines[i];
    if (findings.is_sound(path + ".name") && !names.insert(line.name).second)
      findings.add(path + ".name", fmt::format("there are two sides or lines named '{}'", line.name));
    if (!findings.is_sound(path + ".points")) continue;
    if (line.points.size() < 2)
      findings.add(path + ".points", fmt::format("line '{}' needs at least 2 points", line.name));
    if (has_box) check_inside(data.mesh, line.points, path, fmt::format("line '{}'", line.name), findings);
  }
}

void check_points_per_element(const Case& data, Findings& findings) {
  if (!findings.is_sound("mesh.points_per_element") || !findings.is_sound("geometry.dimension")) return;
  const bool is_plane = data.mesh.dimension == 2;
  const std::set<int> allowed = is_plane ? std::set{1, 3, 6, 12} : std::set{1, 4, 8, 10};
  if (allowed.count(data.points_per_element) == 0)
    findings.add("mesh.points_per_element",
                 fmt::format("'points_per_element' is {}; in {}D it must be {}", data.points_per_element,
                             data.mesh.dimension, is_plane ? "1, 3, 6 or 12" : "1, 4, 8 or 10"));
}

void check_softening_length(const Case& data, Findings& findings) {
  if (!data.softening_length || !findings.is_sound("mesh.softening_length")) return;
  const auto softens = [](const auto& material) { return material.second.traits().softens; };
  if (std::none_of(data.materials.begin(), data.materials.end(), softens))
    findings.add(
        "mesh.softening_length",
        fmt::format("'softening_length' has no meaning here: no soil of the case softens; those of model {} do",
                    material::list_words([](const material::Traits& t) { return t.softens; })));
}

}  // namespace

bool check_extent(const Case& data, Findings& findings) {
  constexpr std::size_t most_corners = 5000;
  std::size_t corners = 0;
  std::string longest = "geometry.polygon";
  const auto add = [&](const auto& parts, const char* list) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      corners += parts[i].points.size();
      if (parts[i].points.size() > most_corners) longest = write_index(list, i) + ".points";
    }
  };
  add(data.mesh.polygons, "geometry.polygon");
  add(data.mesh.lines, "geometry.line");
  if (corners > most_corners)
    findings.add(longest, fmt::format("the polygons and lines have {} corners, and a section has at most {}: leave out "
                                      "those that lie nearer together than the elements are large",
                                      corners, most_corners));
  return corners <= most_corners;
}

void check_geometry(const Case& data, Findings& findings) {
  const mesh::Plan& plan = data.mesh;
  check_points_per_element(data, findings);
  check_softening_length(data, findings);
  if (!plan.file.empty()) {
    if (const auto fault = find_file_fault(plan.file, largest_file::mesh))
      findings.add("mesh.file", fault->is_missing
                                    ? fmt::format("the mesh file '{}' does not exist", plan.file)
                                    : fmt::format("the mesh file '{}' cannot be read: {}", plan.file, fault->why));
    for (const char* list : {"geometry.polygon", "geometry.line"})
      if (findings.places.is_given(list))
        findings.add(list, fmt::format("[[{}]] has no meaning where 'mesh.file' is given", list));
    return;
  }
  const bool has_box = findings.is_sound("geometry.box");
  std::set<std::string> names;
  for (std::size_t i = 0; i < plan.polygons.size(); ++i) {
    const std::string path = write_index("geometry.polygon", i);
    const mesh::Polygon& polygon = plan.polygons[i];
    if (findings.is_sound(path + ".name") && !names.insert(polygon.name).second)
      findings.add(path + ".name", fmt::format("there are two polygons named '{}'", polygon.name));
    if (!findings.is_sound(path + ".points")) continue;
    check_polygon(polygon, path, findings);
    if (has_box) check_inside(plan, polygon.points, path, fmt::format("polygon '{}'", polygon.name), findings);
  }
  if (plan.polygons.empty() && findings.is_sound("geometry.polygon") && findings.is_sound("mesh.file"))
    findings.add("geometry.polygon", "there is no soil: add a [[geometry.polygon]], or a mesh 'file' in [mesh]");
  check_lines(data, has_box, findings);
  for (std::size_t i = 0; i < plan.refinements.size(); ++i)
    if (const std::string path = write_index("mesh.refine", i) + ".near";
        plan.refinements[i].near.empty() && findings.is_sound(path))
      findings.add(path, "'near' needs at least one point [x, y]");
}

}  // namespace talus::input
