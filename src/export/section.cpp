// SPDX-License-Identifier: MIT
#include "export/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/units.hpp"
#include "input/case/support.hpp"
#include "mesh/planar.hpp"
#include "output/plots/gnuplot.hpp"
#include "site/initial_water.hpp"
#include "site/seepage_results.hpp"
#include "site/site.hpp"
#include "site/supports.hpp"

namespace talus::exports {
namespace {

using drawing::DrawnLine;
using results::Point;

constexpr const char *soil_colour = "#000000", *ground_colour = "#A0703C", *water_colour = "#2f7fd6",
                     *support_colour = "#7a3b9a";

/// Returns a point inside a polygon and outside those that lie in it: the middle of the widest stretch of several
/// horizontal lines.
std::optional<Point> find_inner_point(const std::vector<mesh::Polygon>& polygons, std::size_t own) {
  const mesh::Polyline& outline = polygons[own].points;
  const double area = std::abs(mesh::compute_area(outline));
  double low = std::numeric_limits<double>::infinity(), high = -low, widest = 0;
  for (const Point& p : outline) low = std::min(low, p[1]), high = std::max(high, p[1]);
  std::optional<Point> best;
  for (const double fraction : {0.503, 0.307, 0.711, 0.151, 0.853, 0.051, 0.949}) {
    const double y = low + fraction * (high - low);
    std::vector<double> crossings;
    for (const mesh::Polygon& polygon : polygons)
      for (std::size_t i = 0; i < polygon.points.size(); ++i) {
        const Point &a = polygon.points[i], &b = polygon.points[(i + 1) % polygon.points.size()];
        if ((a[1] > y) != (b[1] > y)) crossings.push_back(a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]));
      }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 1; i < crossings.size(); ++i) {
      const Point middle{0.5 * (crossings[i - 1] + crossings[i]), y};
      if (crossings[i] - crossings[i - 1] <= widest || !mesh::is_inside(middle, outline)) continue;
      const bool is_other = std::any_of(polygons.begin(), polygons.end(), [&](const mesh::Polygon& other) {
        return &other != &polygons[own] && std::abs(mesh::compute_area(other.points)) < area &&
               mesh::is_inside(middle, other.points);
      });
      if (is_other) continue;
      widest = crossings[i] - crossings[i - 1];
      best = middle;
    }
  }
  return best;
}

/// Returns "slip_lem_spencer_1.434".
std::string name_layer(const results::MethodSurface& surface) {
  std::string name = drawing::slip_prefix;
  for (const char c : surface.name)
    if (c == '.' || c == '[')
      name += '_';
    else if (c != ']')
      name += c;
  return surface.factor ? fmt::format("{}_{:.3f}", name, *surface.factor) : name;
}

class SectionWriter {
 public:
  SectionWriter(const input::Case& data, const std::string& unit)
      : data_(data), metre_(1 / units::get_si_factor(unit)) {
    out_.drawing.unit_code = drawing::find_unit_code(unit);
  }

  void add_soils() {
    const auto& polygons = data_.mesh.polygons;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const auto found = data_.regions.find(polygons[i].name);
      const std::string& soil = found == data_.regions.end() ? polygons[i].name : found->second;
      add_line(soil, soil_colour, polygons[i].points, true);
      if (const auto at = find_inner_point(polygons, i))
        out_.drawing.labels.push_back({soil, polygons[i].name, scale(*at)});
    }
    const double width = (high_[0] - low_[0]) * metre_;
    out_.drawing.text_height = 0.012 * width;
  }

  void add_ground(const site::Site& site) {
    if (site.has_ground()) add_line(drawing::ground_layer, ground_colour, site.ground(), false);
  }

  void add_supports(const site::Site& site) {
    if (data_.supports.empty()) return;
    for (const site::Bar& bar : site::list_bars(site))
      add_line(drawing::support_layer, support_colour, {bar.head, bar.end}, false);
  }

  void add_water(const results::WaterState& water) {
    for (const auto& line : water.water_table) add_line(drawing::water_layer, water_colour, line, false);
    // Ponds are cut at the corners of the ground below them.
    std::vector<Point> surface;
    for (const results::StandingWater& pond : water.ponds) {
      const Point from{pond.from[0], pond.level_from}, to{pond.to[0], pond.level_to};
      if (surface.empty() || surface.back() != from) {
        add_line(drawing::pond_layer, water_colour, surface, false);
        surface = {from};
      }
      surface.push_back(to);
    }
    add_line(drawing::pond_layer, water_colour, surface, false);
  }

  /// Adds the surfaces, and a legend of their factors above the section.
  void add_surfaces(const std::vector<results::MethodSurface>& surfaces) {
    const double pitch = 1.8 * out_.drawing.text_height, top = high_[1] * metre_ + pitch;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      const results::MethodSurface& surface = surfaces[i];
      const std::string layer = name_layer(surface);
      add_line(layer, output::line_colours[i % std::size(output::line_colours)], surface.points, false);
      const std::string text =
          surface.factor ? fmt::format("{:.3f}  {}", *surface.factor, surface.title) : surface.title;
      out_.drawing.texts.push_back(
          {layer, text, {low_[0] * metre_, top + pitch * static_cast<double>(surfaces.size() - 1 - i)}});
    }
  }

  void remark(const std::string& sentence) { out_.remarks.push_back(sentence); }
  SectionDrawing take() { return std::move(out_); }

 private:
  Point scale(const Point& p) const { return {p[0] * metre_, p[1] * metre_}; }

  void add_line(const std::string& layer, const std::string& colour, const std::vector<Point>& points, bool closed) {
    if (points.size() < 2) return;
    DrawnLine line{layer, "", "", closed, {}};
    for (const Point& p : points) {
      line.points.push_back(scale(p));
      for (std::size_t d = 0; d < 2; ++d) low_[d] = std::min(low_[d], p[d]), high_[d] = std::max(high_[d], p[d]);
    }
    out_.drawing.lines.push_back(std::move(line));
    out_.drawing.colours.try_emplace(layer, colour);
  }

  static constexpr double far_ = std::numeric_limits<double>::infinity();
  const input::Case& data_;
  double metre_;  ///< in units of the drawing
  SectionDrawing out_;
  Point low_{far_, far_}, high_{-far_, -far_};  ///< extent of what is drawn [m]
};

void require_section(const input::Case& data, const std::string& name) {
  if (data.mesh.dimension == 3)
    fail_input("'{}' is a slope in 3D; a DXF shows a plane section. ParaView opens the results of a run in 3D", name);
  if (data.mesh.polygons.empty())
    fail_input("'{}' has no section to draw: its soils are not given as polygons or layers", name);
}

}  // namespace

SectionDrawing draw_run(const report::ResultFolder& folder, const std::string& unit) {
  const std::string name = folder.path.string();
  if (folder.is_study())
    fail_input("'{}' is a study, and a DXF shows one run: give the folder of one of its variants", name);
  if (folder.has_tests_alone)
    fail_input("'{}' has element tests alone, which have no section; export them as .xlsx", name);
  if (folder.run.input.is_empty())
    fail_input("'{}' has no summary.json, which has the section: the run has not finished", name);
  require_section(folder.data, name);
  const results::RunResult& run = folder.run;
  SectionWriter writer(folder.data, unit.empty() ? run.units.length : unit);
  writer.add_soils();
  const site::Site site(folder.data);
  writer.add_ground(site);
  writer.add_supports(site);
  if (run.water_states && !run.water_states->empty()) writer.add_water(run.water_states->back());
  if (run.methods && !run.methods->surfaces.empty())
    writer.add_surfaces(run.methods->surfaces);
  else
    writer.remark("the results have no slip surface");
  return writer.take();
}

SectionDrawing draw_case(const input::Case& data, const std::string& name, const std::string& unit) {
  require_section(data, name);
  SectionWriter writer(data, unit.empty() ? data.output.length_unit : unit);
  const site::Site site(data);
  writer.add_soils();
  writer.add_ground(site);
  writer.add_supports(site);
  const site::WaterResult water = site::make_water_table_result(site);
  if (water.states && !water.states->empty())
    writer.add_water(water.states->back());
  else if (site::needs_seepage(data))
    writer.remark("its water is calculated by a run: export the results of one");
  return writer.take();
}

}  // namespace talus::exports
