// SPDX-License-Identifier: MIT
// Whether the soil polygons fit one another: corners that nearly meet, overlaps and gaps.

#include "mesh/cover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/nearest.hpp"
#include "base/numbers.hpp"
#include "input/case/checks.hpp"
#include "mesh/check_plan.hpp"
#include "mesh/planar.hpp"

namespace talus::input {
namespace {

constexpr const char* polygons_path = "geometry.polygon";

/// "0.2 m² from (0, 4.98) to (20, 5), around (10, 4.995)", of the largest piece.
std::string write_piece(const mesh::Misfit& misfit) {
  const mesh::Piece& piece = misfit.largest;
  const std::string place = fmt::format("from {} to {}, around {}", format_point(piece.low), format_point(piece.high),
                                        format_point(piece.place));
  if (misfit.pieces == 1) return fmt::format("{:.4g} m² {}", misfit.area, place);
  return fmt::format("{:.4g} m² in {} places, the largest of {:.4g} m² {}", misfit.area, misfit.pieces, piece.area,
                     place);
}

std::string write_overlap(const mesh::Misfit& misfit, const mesh::Plan& plan) {
  const std::string &first = plan.polygons[static_cast<std::size_t>(misfit.polygons[0])].name,
                    &second = plan.polygons[static_cast<std::size_t>(misfit.polygons[1])].name;
  if (misfit.kind == mesh::Misfit::Kind::same)
    return fmt::format("polygons '{}' and '{}' are the same: both cover {}", first, second, write_piece(misfit));
  return fmt::format(
      "polygons '{}' and '{}' overlap on {}; they may share edges, or one may lie wholly inside the other. Corners "
      "within {:.2g} m of one another count as one",
      first, second, write_piece(misfit), mesh::get_section_tolerance(plan));
}

std::string write_gap(const mesh::Misfit& misfit, const mesh::Plan& plan) {
  std::string names;
  for (const int p : misfit.polygons)
    names += fmt::format("{}'{}'", names.empty() ? "" : " and ", plan.polygons[static_cast<std::size_t>(p)].name);
  if (misfit.polygons.size() == 1)
    return fmt::format("polygon {} has no soil below an overhang, or in a cavity, of {}", names, write_piece(misfit));
  return fmt::format("there is no soil between polygons {} on {}", names, write_piece(misfit));
}

bool has_sound_polygons(const Case& data, const Findings& findings) {
  return data.mesh.file.empty() && !data.mesh.polygons.empty() && findings.is_sound(polygons_path) &&
         findings.is_sound("geometry.box") && findings.is_sound("geometry.line");
}

/// Other programs close a polygon with its first corner.
void drop_closing_corner(mesh::Polygon& polygon) {
  if (polygon.points.size() > 3 && polygon.points.front() == polygon.points.back()) polygon.points.pop_back();
}

/// Size of the smallest elements in and around a polygon [m].
double find_smallest_size(const mesh::Plan& plan, const mesh::Polygon& polygon) {
  mesh::Point2 low = polygon.points.front(), high = low;
  for (const mesh::Point2& p : polygon.points)
    for (std::size_t d = 0; d < 2; ++d) low[d] = std::min(low[d], p[d]), high[d] = std::max(high[d], p[d]);
  double size = plan.size;
  for (const mesh::Refinement& r : plan.refinements)
    for (const mesh::Point2& p : r.near)
      if (p[0] > low[0] - r.distance && p[0] < high[0] + r.distance && p[1] > low[1] - r.distance &&
          p[1] < high[1] + r.distance)
        size = std::min(size, r.size);
  return size;
}

/// Soil that ends just short of the box: the elements in the gap set the time step.
void warn_of_slivers(const mesh::Plan& plan, Findings& findings) {
  constexpr double narrow = 0.1;  // of an element
  const double tolerance = mesh::get_section_tolerance(plan);
  const std::array sides{std::tuple{"left", 0, plan.box_min[0]}, std::tuple{"right", 0, plan.box_max[0]},
                         std::tuple{"bottom", 1, plan.box_min[1]}, std::tuple{"top", 1, plan.box_max[1]}};
  for (const auto& [side, axis, wall] : sides) {
    double gap = narrow * plan.size;
    const mesh::Polygon* nearest = nullptr;
    for (const mesh::Polygon& polygon : plan.polygons)
      for (const auto& p : polygon.points)
        if (const double d = std::abs(p[axis] - wall); d > 1e-3 * tolerance && d < gap) gap = d, nearest = &polygon;
    if (nearest != nullptr)
      findings.warn("geometry.box",
                    fmt::format("a corner of polygon '{}' is {:.2g} m from the {} side of the box: elements of that "
                                "width set the time step. Let the polygon end on the side, or {:.2g} m from it",
                                nearest->name, gap, side, plan.size));
  }
}

/// Seams without room for one element.
void warn_of_seams(const mesh::Plan& plan, Findings& findings) {
  constexpr double rounding = 1e-6;
  for (std::size_t i = 0; i < plan.polygons.size(); ++i) {
    const auto& p = plan.polygons[i].points;
    const double size = find_smallest_size(plan, plan.polygons[i]);
    double outline = 0;
    for (std::size_t k = 0; k < p.size(); ++k)
      outline += std::hypot(p[(k + 1) % p.size()][0] - p[k][0], p[(k + 1) % p.size()][1] - p[k][1]);
    // The shorter side of the rectangle with this outline and area.
    const double quarter = outline / 4, square = quarter * quarter - std::abs(mesh::compute_area(p));
    const double width = quarter - std::sqrt(std::max(0.0, square));
    if (width < (1 - rounding) * size)
      findings.warn(fmt::format("{}.{}.points", polygons_path, i),
                    fmt::format("polygon '{}' is {:.2g} m thick on average, less than one element of {:.3g} m: shear "
                                "in it is not resolved. Give it smaller elements with [[mesh.refine]]",
                                plan.polygons[i].name, width, size));
  }
}

/// What the mesh generator would refuse, where there will be a mesh.
void check_for_mesher(const Case& data, Findings& findings) {
  const bool has_bounds = uses(data, Method::bounds);
  if (!uses(data, Method::fem) && !uses(data, Method::mpm) && !has_bounds) return;
  mesh::Plan plan = data.mesh;
  if (plan.size <= 0) plan.size = data.fem.size.value_or(has_bounds ? find_bounds_size(data) : 0);
  if (plan.size <= 0 || !findings.is_sound("bounds") || !findings.is_sound("geometry") || !findings.is_sound("mesh") ||
      !findings.is_sound("fem"))
    return;
  try {
    mesh::check_plan(plan);
  } catch (const Error& error) {
    return findings.add("geometry", error.what());
  }
  if (uses(data, Method::mpm)) warn_of_slivers(plan, findings);
  if (uses(data, Method::mpm) || uses(data, Method::fem)) warn_of_seams(plan, findings);
}

}  // namespace

void join_polygons(Case& data, Findings& findings) {
  for (mesh::Polygon& polygon : data.mesh.polygons) drop_closing_corner(polygon);
  if (!has_sound_polygons(data, findings)) return;
  const std::vector<mesh::Joined> joined = mesh::join_corners(data.mesh);
  const double tolerance = mesh::get_section_tolerance(data.mesh);
  for (std::size_t i = 0; i < joined.size();) {
    std::size_t end = i + 1;
    while (end < joined.size() && joined[end].name == joined[i].name) ++end;
    findings.warn(
        polygons_path,
        fmt::format("{} of '{}' moved onto what {} by less than {:.2g} m; the first goes from ({:.9g}, {:.9g}) "
                    "to ({:.9g}, {:.9g}). Give both the same coordinates",
                    end - i == 1 ? "one point" : fmt::format("{} points", end - i), joined[i].name,
                    end - i == 1 ? "it misses" : "they miss", tolerance, joined[i].from[0], joined[i].from[1],
                    joined[i].to[0], joined[i].to[1]));
    i = end;
  }
  for (mesh::Polygon& polygon : data.mesh.polygons) drop_closing_corner(polygon);
}

void check_cover(const Case& data, Findings& findings) {
  if (!has_sound_polygons(data, findings)) return;
  for (const mesh::Misfit& misfit : mesh::find_misfits(data.mesh)) {
    if (misfit.kind != mesh::Misfit::Kind::gap) {
      findings.add(fmt::format("{}.{}.points", polygons_path, misfit.polygons[1]), write_overlap(misfit, data.mesh));
    } else if (uses(data, Method::lem)) {
      findings.add(polygons_path, write_gap(misfit, data.mesh) +
                                      "; slices need soil without gaps, overhangs and cavities from the ground down");
    } else {
      findings.warn(polygons_path,
                    write_gap(misfit, data.mesh) +
                        ". Close the gap, or name 'geometry.polygon' in 'unusual' where it is an overhang or a cavity");
    }
  }
  check_for_mesher(data, findings);
}

void check_unusual(const Case& data, Findings& findings) {
  for (std::size_t i = 0; i < data.unusual.size(); ++i) {
    const std::string& key = data.unusual[i];
    if (findings.places.is_given(key)) continue;
    const std::string near = find_nearest(key, findings.places.list_given());
    findings.add(fmt::format("unusual.{}", i),
                 fmt::format("'unusual' names '{}', which this case does not give{}", key,
                             near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
  }
}

}  // namespace talus::input
