// SPDX-License-Identifier: MIT
#include "input/case/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"
#include "input/case/checks.hpp"
#include "input/language/visitor.hpp"
#include "mesh/cover.hpp"
#include "mesh/plan.hpp"
#include "mesh/planar.hpp"

namespace talus::input {

void describe(Visitor& v, mesh::Polygon& p) {
  v.key("name", p.name, plain().required().example(R"("soil")"), "Name of the region; [regions] gives it a material.");
  v.key("points", p.points, quantity("m").required().example("[[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]]"),
        "Corners in order, either way round; the first is not repeated. The sides must not cross.");
}

void describe(Visitor& v, mesh::Line& l) {
  v.key("name", l.name, plain().required().example(R"("crest")"), "Name for boundary conditions and tractions.");
  v.key("points", l.points, quantity("m").required().example("[[0, 15], [12, 15]]"),
        "Points of the polyline. In 3D it is the trace of a wall that is extruded with the section.");
}

void describe(Visitor& v, GeometryBlock& g) {
  mesh::Plan& plan = g.plan;
  const bool has_file = !plan.file.empty();
  v.key("dimension", plan.dimension, plain().at_least(2).at_most(3),
        "2: plane strain, per metre of thickness. 3: the section is extruded along z.");
  Corners box{plan.box_min, plan.box_max};
  v.key("box", box,
        quantity("m").needed_without("mesh.file", has_file).by_methods({"mpm"}).example("[[0, 0], [44, 17]]"),
        "The background box: the room in which the soil may move. Its sides are named left, right, bottom and top. "
        "Without it, methods other than MPM use the bounding box of the polygons.");
  v.key("thickness", plan.thickness, quantity("m").above(0).needed_with("dimension", plan.dimension, 3).example("5"),
        "Length of the extrusion along z, from the side front (z = 0) to the side back (z = thickness).");
  v.key("ground", g.layering.ground, quantity("m").example("[[0, 15], [12, 15], [32, 5], [44, 5]]"),
        "The ground of a section of layers, from left to right, as points or from a table; its ends are those of the "
        "section. Vertical steps are allowed, overhangs need polygons.");
  v.key("smallest_thickness", g.layering.smallest_thickness, quantity("m").at_least(0),
        "Soil of a layer that is thinner is removed; the boundary moves onto the one above.");
  v.tables("polygon", plan.polygons, 1,
           "A region of soil at the start. Regions may share edges, or one may lie inside another and replace it "
           "there; they must not overlap otherwise. What no polygon covers is empty.");
  v.tables("layer", g.layering.layers, 0,
           "A layer below `ground`, from the top down; the polygons of the section are built from them. The lower "
           "boundary of the last layer is the base of the section.");
  v.tables("line", plan.lines, 0, "A named line that element sides follow.");
}

void describe(Visitor& v, mesh::Refinement& r) {
  v.key("near", r.near, quantity("m").required().example("[[12, 15], [32, 5]]"), "One point, or a polyline.");
  v.key("size", r.size, quantity("m").above(0).required().example("0.3"), "Element size there.");
  v.key("distance", r.distance, quantity("m").above(0).required().example("2"),
        "Distance at which the general size is reached again.");
}

void describe(Visitor& v, MeshBlock& m) {
  mesh::Plan& plan = m.plan;
  v.key("file", plan.file, plain().example(R"("ready.msh")"),
        "A ready mesh in Gmsh's format (.msh, version 4) instead of polygons; its path is relative to the case file. "
        "Physical groups of elements are regions (\"empty\" is the empty one), groups of sides are sides.");
  const bool has_file = !plan.file.empty();
  v.key(
      "size", plan.size, quantity("m").above(0).needed_without("file", has_file).by_methods({"mpm"}).example("0.75"),
      "General size of an element: the length of its sides. FEM and seepage without MPM need it as well, or `size` in "
      "[fem].");
  v.key("algorithm", plan.algorithm, plain().allowed_without("file", has_file), "Gmsh's algorithm for the triangles.");
  v.key("points_per_element", m.points_per_element, plain().at_least(1).at_most(12),
        "Material points in each element filled with soil: 1, 3, 6 or 12 in 2D; 1, 4, 8 or 10 in 3D (where the default "
        "is 4).");
  v.key("softening_length", m.softening_length, quantity("m").above(0).by_methods({"mpm"}).example("0.3"),
        "Nonlocal length: the plastic strain that softens is averaged over this radius, in MPM and in FEM with [fem] "
        "softening = \"progressive\". At least twice the size of the elements where a band forms. If not given, bands "
        "are as thick as the elements, and the results depend on their size.");
  v.tables("refine", plan.refinements, 0, "Smaller elements near a point or a polyline.");
}

namespace {

using Point = std::array<double, 2>;

std::string write_index(const char* list, std::size_t i) {
  return fmt::format("{}.{}", list, i);
}

/// Returns twice the signed area of the triangle abc [m²].
double measure_turn(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool is_between(const Point& a, const Point& b, const Point& p) {
  return std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) && std::min(a[1], b[1]) <= p[1] &&
         p[1] <= std::max(a[1], b[1]);
}

/// Returns true if the segments ab and cd intersect or touch.
bool do_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double abc = measure_turn(a, b, c), abd = measure_turn(a, b, d);
  const double cda = measure_turn(c, d, a), cdb = measure_turn(c, d, b);
  if (((abc > 0) != (abd > 0)) && ((cda > 0) != (cdb > 0)) && abc != 0 && abd != 0 && cda != 0 && cdb != 0) return true;
  return (abc == 0 && is_between(a, b, c)) || (abd == 0 && is_between(a, b, d)) || (cda == 0 && is_between(c, d, a)) ||
         (cdb == 0 && is_between(c, d, b));
}

void check_inside(const mesh::Plan& plan, const std::vector<Point>& points, const std::string& path,
                  const std::string& what, Findings& findings) {
  // Coordinates converted from other units have rounding errors; 1e-9 of the box is far below any element size.
  const double slack = 1e-9 * std::max(plan.box_max[0] - plan.box_min[0], plan.box_max[1] - plan.box_min[1]);
  const ShownUnit& length = plan.units.length;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    if (p[0] < plan.box_min[0] - slack || p[0] > plan.box_max[0] + slack || p[1] < plan.box_min[1] - slack ||
        p[1] > plan.box_max[1] + slack)
      findings.add(fmt::format("{}.points.{}", path, i), "the point {} of {} is outside the box from {} to {}",
                   format_point(p, length), what, format_point(plan.box_min, length),
                   format_point(plan.box_max, length));
  }
}

void check_polygon(const mesh::Polygon& polygon, const ShownUnit& length, const std::string& path, Findings& findings) {
  const std::vector<Point>& p = polygon.points;
  const std::size_t n = p.size();
  if (n < 3) return findings.add(path + ".points", "polygon '{}' has {} points; it needs at least 3", polygon.name, n);
  for (std::size_t i = 0; i < n; ++i)
    if (p[i] == p[(i + 1) % n])
      return findings.add(fmt::format("{}.points.{}", path, (i + 1) % n),
                          "polygon '{}' repeats its point {}; each corner is written once", polygon.name,
                          format_point(p[i], length));
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = p[i], &b = p[(i + 1) % n], &c = p[(i + 2) % n];
    const double forward = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
    if (measure_turn(a, b, c) == 0 && forward < 0)
      return findings.add(fmt::format("{}.points.{}", path, (i + 1) % n),
                          "polygon '{}' crosses itself: it turns back on itself at {}", polygon.name,
                          format_point(b, length));
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // adjacent segments share a corner
      if (do_meet(p[i], p[i + 1], p[j], p[(j + 1) % n]))
        return findings.add(fmt::format("{}.points.{}", path, j),
                            "polygon '{}' crosses itself: its side from {} to {} meets that from {} to {}",
                            polygon.name, format_point(p[i], length), format_point(p[i + 1], length),
                            format_point(p[j], length), format_point(p[(j + 1) % n], length));
    }
  }
  double area = 0;
  for (std::size_t i = 1; i + 1 < n; ++i) area += measure_turn(p[0], p[i], p[i + 1]);
  if (area == 0) findings.add(path + ".points", "polygon '{}' has no area", polygon.name);
}

void check_lines(const Case& data, bool has_box, Findings& findings) {
  std::set<std::string> names{"left", "right", "bottom", "top"};
  if (data.mesh.dimension == 3) names.insert({"front", "back"});
  for (std::size_t i = 0; i < data.mesh.lines.size(); ++i) {
    const std::string path = write_index("geometry.line", i);
    const mesh::Line& line = data.mesh.lines[i];
    if (findings.is_sound(path + ".name") && !names.insert(line.name).second)
      findings.add(path + ".name", "there are two sides or lines named '{}'", line.name);
    if (!findings.is_sound(path + ".points")) continue;
    if (line.points.size() < 2) findings.add(path + ".points", "line '{}' needs at least 2 points", line.name);
    if (has_box) check_inside(data.mesh, line.points, path, fmt::format("line '{}'", line.name), findings);
  }
}

void check_points_per_element(const Case& data, Findings& findings) {
  if (!findings.is_sound("mesh.points_per_element") || !findings.is_sound("geometry.dimension")) return;
  const bool is_plane = data.mesh.dimension == 2;
  const std::set<int> allowed = is_plane ? std::set{1, 3, 6, 12} : std::set{1, 4, 8, 10};
  if (allowed.count(data.points_per_element) == 0)
    findings.add("mesh.points_per_element", "'points_per_element' is {}; in {}D it must be {}", data.points_per_element,
                 data.mesh.dimension, is_plane ? "1, 3, 6 or 12" : "1, 4, 8 or 10");
}

void check_softening_length(const Case& data, Findings& findings) {
  if (!data.softening_length || !findings.is_sound("mesh.softening_length")) return;
  const auto softens = [](const auto& material) { return material.second.traits().softens; };
  if (std::none_of(data.materials.begin(), data.materials.end(), softens))
    findings.add("mesh.softening_length",
                 "'softening_length' has no meaning here: no soil of the case softens; those of model {} do",
                 material::list_words([](const material::Traits& t) { return t.softens; }));
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
    findings.add(longest,
                 "the polygons and lines have {} corners, and a section has at most {}: leave out those that lie "
                 "nearer together than the elements are large",
                 corners, most_corners);
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
      if (findings.places.is_given(list)) findings.add(list, "[[{}]] has no meaning where 'mesh.file' is given", list);
    return;
  }
  const bool has_box = findings.is_sound("geometry.box");
  check_names(plan.polygons, "geometry.polygon", "polygons", findings);
  for (std::size_t i = 0; i < plan.polygons.size(); ++i) {
    const std::string path = write_index("geometry.polygon", i);
    const mesh::Polygon& polygon = plan.polygons[i];
    if (!findings.is_sound(path + ".points")) continue;
    check_polygon(polygon, plan.units.length, path, findings);
    if (has_box) check_inside(plan, polygon.points, path, fmt::format("polygon '{}'", polygon.name), findings);
  }
  const auto is_sound = [&](const char* path) { return findings.is_sound(path); };
  const std::array sources{"geometry.polygon", "geometry.ground", "geometry.layer", "mesh.file"};
  if (plan.polygons.empty() && std::all_of(sources.begin(), sources.end(), is_sound))
    findings.add(
        "geometry.polygon",
        "there is no soil: add a [[geometry.polygon]], a 'ground' in [geometry] with a [[geometry.layer]], or a "
        "mesh 'file' in [mesh]");
  check_lines(data, has_box, findings);
  for (std::size_t i = 0; i < plan.refinements.size(); ++i)
    if (const std::string path = write_index("mesh.refine", i) + ".near";
        plan.refinements[i].near.empty() && findings.is_sound(path))
      findings.add(path, "'near' needs at least one point [x, y]");
}

SoilOutline::SoilOutline(const mesh::Plan& plan) : plan_(plan) {
  for (const mesh::Polygon& polygon : plan.polygons) {
    for (const auto& p : polygon.points) {
      left_ = std::min(left_, p[0]);
      right_ = std::max(right_, p[0]);
      bottom_ = std::min(bottom_, p[1]);
      top_ = std::max(top_, p[1]);
    }
  }
}

std::string SoilOutline::write_span() const {
  const ShownUnit& length = units().length;
  return fmt::format("which goes from x = {} to x = {}", format_coordinate(left_, length),
                     format_coordinate(right_, length));
}

double SoilOutline::find_ground(double x) const {
  if (spans(x)) x = std::clamp(x, left_, right_);
  double level = -far_;
  for (const mesh::Polygon& polygon : plan_.polygons) {
    const auto& p = polygon.points;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const auto &a = p[i], &b = p[(i + 1) % p.size()];
      if (x < std::min(a[0], b[0]) || x > std::max(a[0], b[0])) continue;
      const double share = a[0] == b[0] ? 0 : (x - a[0]) / (b[0] - a[0]);
      level = std::max(level, a[0] == b[0] ? std::max(a[1], b[1]) : a[1] + share * (b[1] - a[1]));
    }
  }
  return level;
}

// Checks of the cover by soil polygons: corners that nearly coincide, overlaps and gaps.

namespace {

constexpr const char* polygons_path = "geometry.polygon";

/// Writes the largest piece of a misfit: "0.2 m² from (0, 4.98) to (20, 5), around (10, 4.995)".
std::string write_piece(const mesh::Misfit& misfit, const ShownUnits& units) {
  const mesh::Piece& piece = misfit.largest;
  const ShownUnit &length = units.length, area = units.area();
  const std::string place = fmt::format("from {} to {}, around {}", format_point(piece.low, length),
                                        format_point(piece.high, length), format_point(piece.place, length));
  if (misfit.pieces == 1) return fmt::format("{} {}", format_value(misfit.area, area, 4), place);
  return fmt::format("{} in {} places, the largest of {} {}", format_value(misfit.area, area, 4), misfit.pieces,
                     format_value(piece.area, area, 4), place);
}

std::string write_overlap(const mesh::Misfit& misfit, const mesh::Plan& plan) {
  const std::string &first = plan.polygons[static_cast<std::size_t>(misfit.polygons[0])].name,
                    &second = plan.polygons[static_cast<std::size_t>(misfit.polygons[1])].name;
  if (misfit.kind == mesh::Misfit::Kind::same)
    return fmt::format("polygons '{}' and '{}' are the same: both cover {}", first, second,
                       write_piece(misfit, plan.units));
  return fmt::format(
      "polygons '{}' and '{}' overlap on {}; they may share edges, or one may lie wholly inside the other. Corners "
      "within {} of one another count as one",
      first, second, write_piece(misfit, plan.units),
      format_value(mesh::get_section_tolerance(plan), plan.units.length, 2));
}

std::string write_gap(const mesh::Misfit& misfit, const mesh::Plan& plan) {
  std::string names;
  for (const int p : misfit.polygons)
    names += fmt::format("{}'{}'", names.empty() ? "" : " and ", plan.polygons[static_cast<std::size_t>(p)].name);
  if (misfit.polygons.size() == 1)
    return fmt::format("polygon {} has no soil below an overhang, or in a cavity, of {}", names,
                       write_piece(misfit, plan.units));
  return fmt::format("there is no soil between polygons {} on {}", names, write_piece(misfit, plan.units));
}

bool has_sound_polygons(const Case& data, const Findings& findings) {
  return data.mesh.file.empty() && !data.mesh.polygons.empty() && findings.is_sound(polygons_path) &&
         findings.is_sound("geometry.box") && findings.is_sound("geometry.line");
}

/// Removes a last corner that repeats the first, as some programs close polygons.
void drop_closing_corner(mesh::Polygon& polygon) {
  if (polygon.points.size() > 3 && polygon.points.front() == polygon.points.back()) polygon.points.pop_back();
}

/// Removes polygons of layers without area after their corners were joined, and the materials of their regions.
void drop_collapsed(Case& data, const Findings& findings) {
  if (!findings.places.is_given("geometry.layer")) return;
  std::erase_if(data.mesh.polygons, [&](const mesh::Polygon& polygon) {
    if (polygon.points.size() > 2) return false;
    data.regions.erase(polygon.name);
    return true;
  });
}

/// Returns the size of the smallest elements in and around a polygon [m].
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

/// Warns of soil that ends just short of the box: the elements in the narrow gap limit the time step.
void warn_of_slivers(const mesh::Plan& plan, Findings& findings) {
  constexpr double narrow = 0.1;  // fraction of an element
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
                    "a corner of polygon '{}' is {} from the {} side of the box: elements of that width set the time "
                    "step. Let the polygon end on the side, or {} from it",
                    nearest->name, format_value(gap, plan.units.length, 2), side,
                    format_value(plan.size, plan.units.length, 2));
  }
}

/// Warns of seams that are narrower than one element.
void warn_of_seams(const mesh::Plan& plan, Findings& findings) {
  constexpr double rounding = 1e-6;
  for (std::size_t i = 0; i < plan.polygons.size(); ++i) {
    const auto& p = plan.polygons[i].points;
    const double size = find_smallest_size(plan, plan.polygons[i]);
    double outline = 0;
    for (std::size_t k = 0; k < p.size(); ++k)
      outline += std::hypot(p[(k + 1) % p.size()][0] - p[k][0], p[(k + 1) % p.size()][1] - p[k][1]);
    // Width of the rectangle with the same perimeter and area.
    const double quarter = outline / 4, square = quarter * quarter - std::abs(mesh::compute_area(p));
    const double width = quarter - std::sqrt(std::max(0.0, square));
    if (width < (1 - rounding) * size)
      findings.warn(fmt::format("{}.{}.points", polygons_path, i),
                    "polygon '{}' is {} thick on average, less than one element of {}: shear in it is not resolved. "
                    "Give it smaller elements with [[mesh.refine]]",
                    plan.polygons[i].name, format_value(width, plan.units.length, 2),
                    format_value(size, plan.units.length, 3));
  }
}

/// Reports faults that the mesh generator would reject, if the case needs a mesh.
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
  const ShownUnit& length = data.units().length;
  for (std::size_t i = 0; i < joined.size();) {
    std::size_t end = i + 1;
    while (end < joined.size() && joined[end].name == joined[i].name) ++end;
    findings.warn(polygons_path,
                  "{} of '{}' moved onto what {} by less than {}; the first goes from ({:.9g}, {:.9g}) to ({:.9g}, "
                  "{:.9g}). Give both the same coordinates",
                  end - i == 1 ? "one point" : fmt::format("{} points", end - i), joined[i].name,
                  end - i == 1 ? "it misses" : "they miss", format_value(tolerance, length, 2),
                  joined[i].from[0] / length.si, joined[i].from[1] / length.si, joined[i].to[0] / length.si,
                  joined[i].to[1] / length.si);
    i = end;
  }
  drop_collapsed(data, findings);
}

void check_cover(const Case& data, Findings& findings) {
  if (!has_sound_polygons(data, findings)) return;
  for (const mesh::Misfit& misfit : mesh::find_misfits(data.mesh)) {
    if (misfit.kind != mesh::Misfit::Kind::gap) {
      findings.add(fmt::format("{}.{}.points", polygons_path, misfit.polygons[1]), write_overlap(misfit, data.mesh));
    } else if (uses(data, Method::lem)) {
      findings.add(polygons_path, write_gap(misfit, data.mesh) +
                                      "; LEM needs soil without gaps, overhangs and cavities from the ground down");
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
    findings.add(fmt::format("unusual.{}", i), "'unusual' names '{}', which this case does not give{}", key,
                 near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
  }
}

}  // namespace talus::input
