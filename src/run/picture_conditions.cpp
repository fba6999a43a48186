// SPDX-License-Identifier: MIT
// Supports, water, loads and roots of the picture of a case.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/numbers.hpp"
#include "input/case/geometry.hpp"
#include "input/case/support_places.hpp"
#include "mesh/planar.hpp"
#include "run/picture_parts.hpp"
#include "site/ground_line.hpp"
#include "site/standing_water.hpp"

namespace talus::run {
namespace {

using Point = results::Point;
using Polyline = std::vector<Point>;
using Picture = output::CasePicture;

/// Returns the direction out of the soil on a line.
std::array<double, 2> find_outward(const PictureSource& source, const Picture& picture, const std::string& name,
                                   const Polyline& line) {
  if (source.mesh_sides.empty()) {
    if (name == "left") return {-1, 0};
    if (name == "right") return {1, 0};
    if (name == "bottom") return {0, -1};
    if (name == "top") return {0, 1};
  }
  if (line.size() < 2) return {0, 1};
  const std::size_t middle = (line.size() - 1) / 2;
  const Point &a = line[middle], &b = line[middle + 1];
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  if (!(length > 0)) return {0, 1};
  const std::array<double, 2> normal{-(b[1] - a[1]) / length, (b[0] - a[0]) / length};
  const double off = 0.05 * length;
  const Point beside{(a[0] + b[0]) / 2 + off * normal[0], (a[1] + b[1]) / 2 + off * normal[1]};
  const bool is_soil = std::any_of(picture.soils.begin(), picture.soils.end(), [&](const Picture::Soil& s) {
    return s.outline.size() > 2 && mesh::is_inside(beside, s.outline);
  });
  return is_soil ? std::array{-normal[0], -normal[1]} : normal;
}

void add_supports(const PictureSource& source, Picture& picture, std::set<std::string>& named) {
  using output::SupportKind;
  for (const input::Boundary& b : source.data.boundaries) {
    Picture::Support support{SupportKind::fixed, source.find_line(b.on), "", {}};
    if (support.line.size() < 2) continue;
    support.outward = find_outward(source, picture, b.on, support.line);
    switch (b.fix) {
      case input::Fix::full:
        break;
      case input::Fix::normal:
        support.kind = SupportKind::rollers;
        break;
      case input::Fix::plane:
        support.kind = SupportKind::plane;
        support.text = fmt::format("{}: normal ({:.3g}, {:.3g})", b.on, b.normal[0], b.normal[1]);
        break;
      case input::Fix::friction:
        support.kind = SupportKind::wall;
        support.text = fmt::format("{}: μ = {:g}", b.on, b.friction);
        break;
      case input::Fix::velocity: {
        support.kind = SupportKind::moving;
        const double speed = std::hypot(b.velocity[0], b.velocity[1]);
        support.text = fmt::format("{}: {}", b.on, format_value(speed, source.data.units().speed(), 3));
        if (speed > 0) support.outward = {b.velocity[0] / speed, b.velocity[1] / speed};
      }
    }
    const bool is_line = std::any_of(source.data.mesh.lines.begin(), source.data.mesh.lines.end(),
                                     [&](const mesh::Line& l) { return l.name == b.on; });
    if (is_line && support.text.empty()) support.text = b.on;
    if (is_line) named.insert(b.on);
    picture.supports.push_back(std::move(support));
  }
}

/// Adds the water that a water table above the ground makes.
void add_flooded(const PictureSource& source, const Polyline& table, Picture& picture) {
  if (source.ground.size() < 2 || table.empty()) return;
  std::vector<double> breaks;
  for (const Polyline* line : {&source.ground, &table})
    for (const Point& p : *line)
      if (p[0] >= source.ground.front()[0] && p[0] <= source.ground.back()[0]) breaks.push_back(p[0]);
  std::sort(breaks.begin(), breaks.end());
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const double width = breaks[i] - breaks[i - 1];
    if (!(width > 1e-9 * (source.ground.back()[0] - source.ground.front()[0]))) continue;
    // Inside the interval, so that a vertical step counts on its own side.
    double a = breaks[i - 1] + 1e-9 * width, b = breaks[i] - 1e-9 * width;
    const auto over = [&](double x) { return site::find_water_table(table, x) - site::find_level(source.ground, x); };
    const double over_a = over(a), over_b = over(b);
    if (over_a <= 0 && over_b <= 0) continue;
    if (over_a * over_b < 0) (over_a < 0 ? a : b) = a + (b - a) * over_a / (over_a - over_b);
    picture.ponds.push_back({{a, site::find_level(source.ground, a)},
                             {a, site::find_water_table(table, a)},
                             {b, site::find_water_table(table, b)},
                             {b, site::find_level(source.ground, b)}});
  }
}

void add_water(const PictureSource& source, Picture& picture) {
  const auto add_table = [&](const Polyline& table, const std::string& name, bool is_later) {
    if (table.empty()) return;
    Polyline line = table;
    const input::SoilOutline soil(source.data.mesh);
    // A water table is level beyond its ends.
    if (soil.left() < line.front()[0]) line.insert(line.begin(), {soil.left(), line.front()[1]});
    if (soil.right() > line.back()[0]) line.push_back({soil.right(), line.back()[1]});
    picture.water_tables.push_back({name, line, is_later});
  };
  const auto is_ordered = [](const Polyline& line) {
    return std::is_sorted(line.begin(), line.end(), [](const Point& a, const Point& b) { return a[0] < b[0]; });
  };
  const bool has_drawdown = source.data.lem.drawdown && input::uses(source.data, input::Method::lem);
  const Polyline& table = source.data.initial.water.water_table;
  add_table(table, has_drawdown ? "water table before drawdown" : "water table", false);
  if (has_drawdown) add_table(source.data.lem.drawdown->water_table, "water table after drawdown", true);
  for (const input::PiezometricLine& line : source.data.initial.water.lines)
    add_table(line.points, fmt::format("piezometric line of {}", fmt::join(line.materials, ", ")), false);
  if (is_ordered(table)) add_flooded(source, table, picture);
  for (const input::Slurry& slurry : source.data.slurries) {
    if (source.ground.size() < 2 || !(slurry.x[0] < slurry.x[1])) continue;
    PictureSource part{source.sketch, {}, source.is_faulty, source.cut_ground(slurry.x[0], slurry.x[1])};
    add_flooded(part, {{slurry.x[0], slurry.level}}, picture);
    picture.notes.push_back(fmt::format("Slurry '{}': {:.4g} kN/m³, up to y = {}.", slurry.name,
                                        slurry.unit_weight / 1e3,
                                        format_coordinate(slurry.level, source.data.units().length)));
  }
  if (source.ground.size() < 2) return;
  std::map<double, Point> levels;  // one symbol for each level, on its widest part
  std::map<double, double> widths;
  for (const site::Pond& pond : site::find_ponds(source.data, source.ground, site::find_first_time(source.data))) {
    picture.ponds.push_back({pond.from, {pond.from[0], pond.level_from}, {pond.to[0], pond.level_to}, pond.to});
    double& width = widths[pond.level_from];
    if (pond.to[0] - pond.from[0] <= width) continue;
    width = pond.to[0] - pond.from[0];
    levels[pond.level_from] = {(pond.from[0] + pond.to[0]) / 2, (pond.level_from + pond.level_to) / 2};
  }
  for (const auto& [level, place] : levels) picture.pond_levels.push_back(place);
}

std::string describe_rain(const std::string& on, double rate, const ShownUnit& unit) {
  return fmt::format("{}: {} {}", on, rate < 0 ? "evaporation" : "rain", format_value(std::abs(rate), unit, 3));
}

void add_water_sides(const PictureSource& source, Picture& picture, std::set<std::string>& named) {
  using input::WaterCondition;
  using output::WaterSideKind;
  const double time = site::find_weather_start(source.data);
  for (const input::Hydraulic& h : source.data.hydraulics) {
    const input::TimeTable values = h.values();
    const char* later = values.time.size() > 1 ? ", then as its series" : "";
    Picture::WaterSide side{WaterSideKind::no_flow, source.find_line(h.on), ""};
    if (side.line.size() < 2) continue;
    switch (h.condition) {
      case WaterCondition::total_head:
        side = {
            WaterSideKind::head, side.line,
            fmt::format("{}: head {}{}", h.on, format_coordinate(values.at(time), source.data.units().length), later)};
        break;
      case WaterCondition::pressure:
        side = {WaterSideKind::pressure, side.line,
                fmt::format("{}: pressure {}{}", h.on, format_value(values.at(time), source.data.units().stress, 4),
                            later)};
        break;
      case WaterCondition::seepage_face:
        side = {WaterSideKind::seepage_face, side.line, h.on + ": seepage face"};
        break;
      case WaterCondition::free_drainage:
        side = {WaterSideKind::seepage_face, side.line, h.on + ": free drainage"};
        break;
      case WaterCondition::rain:
        side = {WaterSideKind::rain, side.line,
                describe_rain(h.on, values.at(time), source.data.units().rain()) + later};
        break;
      case WaterCondition::flux:
        side = {
            WaterSideKind::flux, side.line,
            fmt::format("{}: flux {}{}", h.on, format_value(values.at(time), source.data.units().speed(), 4), later)};
        break;
      case WaterCondition::no_flow:
        side.text = h.on + ": no flow";
    }
    named.insert(h.on);
    picture.water_sides.push_back(std::move(side));
  }
}

void add_loads(const PictureSource& source, Picture& picture, std::set<std::string>& named) {
  for (const input::Surcharge& s : source.data.surcharges) {
    if (s.x.size() < 2 || s.x.size() != s.load.size() || source.ground.size() < 2) continue;
    Picture::Load load;
    for (std::size_t i = 1; i < s.x.size(); ++i)
      for (const Point& p : source.cut_ground(s.x[i - 1], s.x[i])) {
        const double width = s.x[i] - s.x[i - 1], t = width > 0 ? (p[0] - s.x[i - 1]) / width : 0;
        load.line.push_back(p);
        load.load.push_back({0, -(s.load[i - 1] + t * (s.load[i] - s.load[i - 1]))});
      }
    const auto ends = std::minmax_element(s.load.begin(), s.load.end());
    const double low = *ends.first, high = *ends.second;
    load.text = low == high ? fmt::format("{}: {}", s.name, format_value(high, source.data.units().stress, 4))
                            : fmt::format("{}: {} to {}", s.name,
                                          format_significant(s.load.front() / source.data.units().stress.si, 4),
                                          format_value(s.load.back(), source.data.units().stress, 4));
    picture.loads.push_back(std::move(load));
  }
  for (const input::Traction& t : source.data.tractions) {
    Picture::Load load{"", source.find_line(t.on), {}};
    if (load.line.size() < 2) continue;
    load.load.assign(load.line.size(), {t.traction[0], t.traction[1]});
    load.text = fmt::format("{}: {}{}", t.on,
                            format_value(std::hypot(t.traction[0], t.traction[1]), source.data.units().stress, 4),
                            t.factor.time.empty() ? "" : ", times a factor");
    named.insert(t.on);
    picture.loads.push_back(std::move(load));
  }
  const input::Earthquake& quake = source.data.earthquake;
  if (quake.horizontal != 0 && source.sketch.is_sound("earthquake"))
    for (const input::EarthquakeDirection direction : quake.list_directions()) {
      const double sign = direction == input::EarthquakeDirection::left ? -1 : 1;
      picture.shaking.push_back(
          {fmt::format("earthquake k_h = {:g}", quake.horizontal), {std::copysign(1.0, quake.horizontal) * sign, 0}});
    }
  if (quake.vertical != 0 && source.sketch.is_sound("earthquake"))
    picture.shaking.push_back(
        {fmt::format("earthquake k_v = {:g}", quake.vertical), {0, quake.vertical > 0 ? -1.0 : 1.0}});
  for (const input::Roots& roots : source.data.roots) {
    const Polyline line = source.find_line(roots.ground);
    if (line.size() < 2) continue;
    named.insert(roots.ground);
    picture.roots.push_back(
        {fmt::format("{}: roots to {}", roots.ground, format_value(roots.depth, source.data.units().length, 3)), line,
         roots.depth});
  }
}

void add_bars(const PictureSource& source, Picture& picture) {
  if (source.ground.size() < 2) return;
  for (const auto& [name, support] : source.data.supports) {
    const input::BarLayout layout = source.data.construction.empty()
                                        ? input::lay_bars(support, source.ground, source.data.units().length)
                                        : input::lay_bars(source.data, name);
    for (const input::BarLine& line : layout.bars) {
      const double length = line.length();
      if (!(length > 0)) continue;
      const double free = support.free_length ? *support.free_length : length - support.bond_length.value_or(length);
      picture.bars.push_back({line.row == 1 ? name : "", line.head, line.end, std::clamp(free / length, 0.0, 1.0)});
    }
  }
}

}  // namespace

void add_conditions(const PictureSource& source, Picture& picture) {
  std::set<std::string> named;  // lines that a condition or a load names
  add_supports(source, picture, named);
  add_water(source, picture);
  add_water_sides(source, picture, named);
  add_loads(source, picture, named);
  add_bars(source, picture);
  for (const mesh::Line& line : source.data.mesh.lines)
    picture.lines.push_back({named.contains(line.name) ? "" : line.name, line.points});
}

}  // namespace talus::run
