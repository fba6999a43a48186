// SPDX-License-Identifier: MIT
#include "run/case_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "input/case/support.hpp"
#include "run/picture_parts.hpp"
#include "site/ground_line.hpp"

namespace talus::run {
namespace {

using Point = results::Point;
using Polyline = std::vector<Point>;
using Picture = output::CasePicture;

/// Returns the case without conditions, loads and points that could not be read.
input::Case make_drawable(const input::Sketch& sketch) {
  input::Case data = sketch.data;
  for (std::size_t i = 0; i < data.mesh.polygons.size(); ++i)
    drop_unread(data.mesh.polygons[i].points, fmt::format("geometry.polygon.{}.points", i), sketch);
  for (std::size_t i = 0; i < data.mesh.lines.size(); ++i)
    drop_unread(data.mesh.lines[i].points, fmt::format("geometry.line.{}.points", i), sketch);
  drop_unread(data.initial.water.water_table, "initial.water_table", sketch);
  if (data.lem.drawdown) drop_unread(data.lem.drawdown->water_table, "lem.drawdown.water_table", sketch);
  const auto drop_unsound = [&](auto& list, const char* name) {
    std::size_t index = 0;
    std::erase_if(list, [&](const auto&) { return !sketch.is_sound(fmt::format("{}.{}", name, index++)); });
  };
  drop_unsound(data.boundaries, "boundary");
  drop_unsound(data.tractions, "traction");
  drop_unsound(data.hydraulics, "hydraulic");
  drop_unsound(data.roots, "roots");
  drop_unsound(data.surcharges, "surcharge");
  std::erase_if(data.supports, [&](const auto& entry) { return !sketch.is_sound("support." + entry.first); });
  drop_unsound(data.lem.surfaces, "lem.surface");
  drop_unsound(data.lem.block.windows, "lem.block.window");
  drop_unsound(data.lem.excluded, "lem.exclude");
  drop_unsound(data.lem.passages, "lem.through");
  return data;
}

bool has_errors(const std::vector<CaseMessage>& messages) {
  return std::any_of(messages.begin(), messages.end(), [](const CaseMessage& m) { return m.is_error; });
}

void add_soils(const PictureSource& source, Picture& picture) {
  for (std::size_t i = 0; i < source.data.mesh.polygons.size(); ++i) {
    const mesh::Polygon& polygon = source.data.mesh.polygons[i];
    const auto material = source.data.regions.find(polygon.name);
    picture.soils.push_back(
        {polygon.name, material == source.data.regions.end() ? "" : material->second, polygon.points});
  }
  if (input::uses(source.data, input::Method::mpm) && source.data.mesh.file.empty() &&
      source.sketch.is_sound("geometry.box")) {
    const auto [x0, y0] = source.data.mesh.box_min;
    const auto [x1, y1] = source.data.mesh.box_max;
    if (x1 > x0 && y1 > y0) picture.box = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  }
}

/// Draws the boundaries of layers that no polygons could be built from.
void add_layers(const PictureSource& source, Picture& picture) {
  const Polyline& ground = source.data.layering.ground.points;
  if (!ground.empty()) picture.lines.push_back({"ground", ground});
  for (const input::LayerInput& layer : source.data.layering.layers) {
    Polyline line = layer.bottom.points;
    if (layer.level && !ground.empty()) line = {{ground.front()[0], *layer.level}, {ground.back()[0], *layer.level}};
    if (!layer.depths.points.empty() && ground.size() > 1)
      for (const Point& borehole : layer.depths.points)
        line.push_back({borehole[0], site::find_level(ground, borehole[0]) - borehole[1]});
    if (line.size() > 1) picture.lines.push_back({layer.name, line});
  }
}

/// Writes a message without the name of the case file.
std::string write_message(const CaseMessage& message, const std::string& case_file) {
  const Diagnostic& d = message.diagnostic;
  std::string place = d.file == case_file || d.file.empty() ? "" : d.file + ": ";
  if (d.line > 0) place += fmt::format("line {}: ", d.line);
  return (message.is_error ? "error: " : "warning: ") + place + d.sentence;
}

}  // namespace

void drop_unread(Polyline& points, const std::string& path, const input::Sketch& sketch) {
  if (sketch.is_sound(path)) return;
  Polyline kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i] != Point{} || sketch.is_given(fmt::format("{}.{}", path, i))) kept.push_back(points[i]);
  points = std::move(kept);
}

PictureSource::Polyline PictureSource::find_line(const std::string& name) const {
  if (const auto found = mesh_sides.find(name); found != mesh_sides.end()) return found->second;
  return find_side_line(data, name);
}

PictureSource::Polyline PictureSource::cut_ground(double from, double to) const {
  if (ground.size() < 2 || !(to >= from)) return {};
  from = std::clamp(from, ground.front()[0], ground.back()[0]);
  to = std::clamp(to, ground.front()[0], ground.back()[0]);
  Polyline line{{from, site::find_level(ground, from)}};
  for (const Point& p : ground)
    if (p[0] > from && p[0] < to) line.push_back(p);
  line.push_back({to, site::find_level(ground, to)});
  return line;
}

Polyline find_side_line(const input::Case& data, const std::string& name) {
  for (const mesh::Line& line : data.mesh.lines)
    if (line.name == name) return line.points;
  const auto [x0, y0] = data.mesh.box_min;
  const auto [x1, y1] = data.mesh.box_max;
  if (!(x1 > x0) || !(y1 > y0)) return {};
  if (name == "bottom") return {{x0, y0}, {x1, y0}};
  if (name == "top") return {{x0, y1}, {x1, y1}};
  if (name != "left" && name != "right") return {};
  const double x = name == "left" ? x0 : x1;
  if (input::uses(data, input::Method::mpm)) return {{x, y0}, {x, y1}};
  // Without MPM a side ends where the soil does.
  double low = y1, high = y0;
  for (const mesh::Polygon& polygon : data.mesh.polygons)
    for (const Point& p : polygon.points)
      if (std::abs(p[0] - x) <= 1e-9 * (x1 - x0)) low = std::min(low, p[1]), high = std::max(high, p[1]);
  return high > low ? Polyline{{x, low}, {x, high}} : Polyline{{x, y0}, {x, y1}};
}

Polyline find_sketched_ground(const input::Sketch& sketch) {
  const mesh::Plan& plan = sketch.data.mesh;
  const auto has_area = [](const mesh::Polygon& polygon) { return polygon.points.size() > 2; };
  if (!sketch.is_small || plan.polygons.empty() || !std::all_of(plan.polygons.begin(), plan.polygons.end(), has_area))
    return {};
  try {
    return site::find_ground(plan);
  } catch (const Error&) {
    return {};
  }
}

namespace {

Picture make_drawing(PictureSource& source, bool has_meshes) {
  Picture picture;
  picture.length = source.data.units().length;
  picture.title = source.data.title;
  add_soils(source, picture);
  add_layers(source, picture);
  if (has_meshes) add_meshes(source, picture);
  add_conditions(source, picture);
  add_search(source, picture);
  return picture;
}

}  // namespace

Picture make_case_picture(const input::Sketch& sketch, const std::vector<CaseMessage>& messages) {
  if (sketch.data.mesh.dimension != 2 && sketch.is_sound("geometry.dimension"))
    fail_input("a picture shows a plane section, but this case has 'dimension' = {} in [geometry]",
               sketch.data.mesh.dimension);
  if (!sketch.is_whole && !has_errors(messages))
    fail_input("a picture shows a section, but this case has element tests only");
  PictureSource source{sketch, make_drawable(sketch), has_errors(messages), find_sketched_ground(sketch)};
  Picture picture = make_drawing(source, true);
  constexpr std::size_t most_places = 300;  // of a hostile file with very many faults
  for (const CaseMessage& message : messages) {
    const bool is_marked = picture.messages.size() < most_places;
    picture.messages.push_back(
        {message.is_error, write_message(message, sketch.file),
         is_marked ? find_message_place(sketch, source.ground, message.diagnostic) : std::nullopt});
  }
  return picture;
}

std::optional<Picture> make_section_picture(const input::Sketch& sketch, bool is_faulty) {
  if (sketch.data.mesh.dimension != 2 || !sketch.is_whole) return std::nullopt;
  PictureSource source{sketch, make_drawable(sketch), is_faulty, find_sketched_ground(sketch)};
  return make_drawing(source, false);
}

std::optional<Picture> make_input_picture(const input::Case& data) {
  if (data.mesh.dimension != 2 || data.mesh.polygons.empty()) return std::nullopt;
  input::Sketch sketch;
  sketch.data = data;
  sketch.is_whole = sketch.is_small = true;
  sketch.is_sound = sketch.is_given = [](const std::string&) { return true; };
  sketch.find_path = [](const Diagnostic&) { return std::string(); };
  const PictureSource source{sketch, data, false, find_sketched_ground(sketch)};
  Picture picture;
  picture.length = data.units().length;
  add_soils(source, picture);
  add_conditions(source, picture);
  add_search(source, picture);
  return picture;
}

}  // namespace talus::run
