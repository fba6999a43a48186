// SPDX-License-Identifier: MIT
// Checks of [lem], [[lem.surface]], [[surcharge]] and [partial_factors]: surfaces and ranges must lie on the soil.
#include "input/case/limit_equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "input/case/checks.hpp"
#include "input/case/geometry.hpp"

namespace talus::input {

namespace {

void check_stretch(const std::vector<double>& range, const std::string& path, const SoilOutline& soil,
                   Findings& findings) {
  if (!check_range(range, path, "places x", findings)) return;
  if (!soil.spans(range[0]) || !soil.spans(range[1]))
    findings.add(path, "'{}' reaches beyond the ground, {}", path.substr(path.rfind('.') + 1), soil.write_span());
}

void check_surcharge(const Surcharge& s, const std::string& path, const SoilOutline& soil, Findings& findings) {
  if (!findings.is_sound(path + ".x") || !findings.is_sound(path + ".load")) return;
  if (s.x.size() != s.load.size())
    return findings.add(path + ".load", "surcharge '{}' has {} places x and {} loads; each place has one", s.name,
                        s.x.size(), s.load.size());
  if (s.x.size() < 2)
    return findings.add(path + ".x", "surcharge '{}' needs at least two places x, from and to", s.name);
  for (std::size_t i = 1; i < s.x.size(); ++i)
    if (s.x[i] <= s.x[i - 1])
      return findings.add(
          path + ".x", "the places x of surcharge '{}' go from {} to {}; they run from left to right, increasing",
          s.name, format_value(s.x[i - 1], soil.units().length), format_value(s.x[i], soil.units().length));
  if (!soil.spans(s.x.front()) || !soil.spans(s.x.back()))
    findings.add(path + ".x", "surcharge '{}' reaches beyond the ground, {}", s.name, soil.write_span());
}

void check_slurry(const Slurry& s, const std::string& path, const SoilOutline& soil, Findings& findings) {
  if (!findings.is_sound(path + ".x")) return;
  if (!(s.x[0] < s.x[1]))
    return findings.add(path + ".x", "the slurry '{}' goes from {} to {}; the second must be larger", s.name,
                        format_value(s.x[0], soil.units().length), format_value(s.x[1], soil.units().length));
  if (!soil.spans(s.x[0]) || !soil.spans(s.x[1]))
    findings.add(path + ".x", "the slurry '{}' reaches beyond the ground, {}", s.name, soil.write_span());
}

void check_grid(const CentreGrid& grid, const SoilOutline& soil, Findings& findings) {
  const std::string corners = "lem.grid.corners", levels = "lem.grid.levels";
  const ShownUnit& length = soil.units().length;
  if (!grid.corners.empty() && findings.is_sound(corners) &&
      !(grid.corners.size() == 2 && grid.corners[0][0] < grid.corners[1][0] && grid.corners[0][1] < grid.corners[1][1]))
    findings.add(corners,
                 "'corners' is to be the lower left and the upper right corner of the grid, two points [x, y]");
  if (check_range(grid.levels, levels, "levels y", findings) &&
      (grid.levels[0] > soil.top() || grid.levels[1] < soil.bottom()))
    findings.add(levels,
                 "no soil lies between the 'levels' of the deepest points, {} and {}; it goes from y = {} to y = {}",
                 format_coordinate(grid.levels[0], length), format_coordinate(grid.levels[1], length),
                 format_coordinate(soil.bottom(), length), format_coordinate(soil.top(), length));
}

void check_crack(const TensionCrack& crack, const ShownUnit& length, Findings& findings) {
  const std::string path = "lem.tension_crack.water";
  if (crack.water > crack.depth && findings.is_sound(path) && findings.is_sound("lem.tension_crack.depth"))
    findings.add(path, "the water in the tension crack is {} high, but the crack is {} deep",
                 format_value(crack.water, length), format_value(crack.depth, length));
}

void check_settings(const LimitEquilibrium& lem, Findings& findings) {
  if (lem.methods.empty() && findings.is_sound("lem.methods"))
    findings.add("lem.methods", "'methods' of [lem] is empty; name at least one method, such as \"spencer\"");
  for (std::size_t i = 1; i < lem.methods.size(); ++i)
    if (std::count(lem.methods.begin(), lem.methods.begin() + static_cast<std::ptrdiff_t>(i), lem.methods[i]) > 0)
      findings.add(fmt::format("lem.methods.{}", i), "this method is named twice");
  if (lem.search == SurfaceSearch::none && lem.surfaces.empty() && findings.is_sound("lem.surface"))
    findings.add("lem.search", "there is nothing to calculate: search = \"none\" and no [[lem.surface]]");
}

void check_partial_factors(const Case& data, Findings& findings) {
  const PartialFactors& p = data.partial_factors;
  const bool has_any = p.cohesion || p.friction || p.undrained || p.weight || p.permanent_load || p.variable_load ||
                       p.resistance || p.bond || p.tensile || p.lateral;
  if (p.set == DesignApproach::by_hand && !has_any && findings.is_sound("partial_factors"))
    findings.add("partial_factors.set", "set = \"by_hand\" needs at least one factor, for example friction = 1.25");
  if (p.set == DesignApproach::none || !findings.is_sound("materials")) return;
  for (const auto& [name, m] : data.materials)
    if (!m.traits().serves_slices ||
        (m.traits().strength == material::Strength::known && !material::is_divisible(m.model)))
      findings.add("partial_factors.set",
                   "partial factors divide cohesion and friction angle, which material '{}' ({}) does not have", name,
                   m.traits().title);
}

}  // namespace

bool check_range(const std::vector<double>& range, const std::string& path, const char* what, Findings& findings) {
  if (range.empty() || !findings.is_sound(path)) return false;
  if (range.size() == 2 && range[0] < range[1]) return true;
  findings.add(path, "'{}' is to be [from, to], two increasing {}", path.substr(path.rfind('.') + 1), what);
  return false;
}

void check_slices(const Case& data, Findings& findings) {
  check_partial_factors(data, findings);
  check_crack(data.lem.crack, data.units().length, findings);
  check_names(data.lem.surfaces, "lem.surface", "slip surfaces", findings);
  check_names(data.surcharges, "surcharge", "surcharges", findings);
  check_names(data.slurries, "slurry", "slurries", findings);
  if (uses(data, Method::lem)) check_settings(data.lem, findings);
  if (!findings.is_sound("geometry.polygon") || data.mesh.polygons.empty()) return;
  const SoilOutline soil(data.mesh);
  check_stretch(data.lem.entry_exit.exit, "lem.entry_exit.exit", soil, findings);
  check_stretch(data.lem.entry_exit.entry, "lem.entry_exit.entry", soil, findings);
  check_grid(data.lem.grid, soil, findings);
  check_slip_search(data, soil, findings);
  for (std::size_t i = 0; i < data.lem.surfaces.size(); ++i)
    if (const std::string path = fmt::format("lem.surface.{}", i); findings.is_sound(path))
      check_slip_surface(data.lem.surfaces[i], path, soil, findings);
  for (std::size_t i = 0; i < data.surcharges.size(); ++i)
    check_surcharge(data.surcharges[i], fmt::format("surcharge.{}", i), soil, findings);
  for (std::size_t i = 0; i < data.slurries.size(); ++i)
    check_slurry(data.slurries[i], fmt::format("slurry.{}", i), soil, findings);
}

// Checks of [lem.drawdown] against the rest of the case.

namespace {

using Line = std::vector<std::array<double, 2>>;

/// Returns the level of a water table at x, horizontal beyond its ends [m].
double find_level(const Line& line, double x) {
  if (x <= line.front()[0]) return line.front()[1];
  for (std::size_t i = 1; i < line.size(); ++i)
    if (x <= line[i][0]) {
      const auto &a = line[i - 1], &b = line[i];
      return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
    }
  return line.back()[1];
}

/// Reports a water table that rises in the drawdown.
void check_fall(const Line& before, const Line& after, const ShownUnit& length, Findings& findings) {
  constexpr double rounding = 1e-9;  // relative to the levels
  for (const Line* line : {&before, &after})
    for (const auto& [x, y] : *line) {
      const double from = find_level(before, x), to = find_level(after, x);
      if (to <= from + rounding * std::max(1.0, std::abs(from))) continue;
      return findings.add(
          "lem.drawdown.water_table",
          "At x = {} the water table after drawdown ({}) is above the one before ({}); drawdown lowers the water",
          format_coordinate(x, length), format_coordinate(to, length), format_coordinate(from, length));
    }
}

void check_soils(const Case& data, Findings& findings) {
  const bool by_b_bar = data.lem.drawdown->method == DrawdownMethod::b_bar;
  bool holds_water = false;
  for (const auto& [name, m] : data.materials) {
    const bool is_used = std::any_of(data.regions.begin(), data.regions.end(),
                                     [&, &name = name](const auto& region) { return region.second == name; });
    holds_water =
        holds_water || (is_used && (by_b_bar ? m.slices.b_bar.has_value() : m.slices.undrained_envelope.has_value()));
  }
  if (holds_water || !findings.is_sound("regions")) return;
  findings.add(
      "lem.drawdown.method",
      by_b_bar
          ? "method = \"b_bar\" of [lem.drawdown] needs a soil with a `b_bar`; all soils drain"
          : fmt::format("method = \"{}\" of [lem.drawdown] needs a soil with an `undrained_envelope`; all soils drain",
                        get_word(data.lem.drawdown->method)));
}

/// Reports methods and loads that would use the state before drawdown, or strengths that no test gives.
void check_others(const Case& data, Findings& findings) {
  const std::string path = "lem.drawdown";
  if (data.methods.size() != 1)
    findings.add(path,
                 "rapid drawdown is calculated by LEM only, and other methods would use the state before "
                 "it: write methods = [\"lem\"] in [analysis]");
  if (data.timeline)
    findings.add(path,
                 "not with [timeline], which follows the water through a drawdown by seepage; take one of the two out");
  if (data.earthquake.horizontal != 0 || data.earthquake.vertical != 0)
    findings.add(path, "not with [earthquake]: an earthquake during a rapid drawdown has no strengths here");
  if (data.lem.yield_acceleration && findings.places.is_given("lem.yield_acceleration"))
    findings.add("lem.yield_acceleration",
                 "not with [lem.drawdown]: an earthquake during a rapid drawdown has no strengths here");
  if (data.partial_factors.set != DesignApproach::none)
    findings.add(path, "not with [partial_factors]: which of them divides an undrained envelope is not agreed on");
  if (data.study.mode == StudyMode::sample && findings.is_sound("study.mode"))
    findings.add(path, "not with mode = \"sample\" in [study]: samples know one state of the water");
}

}  // namespace

void check_drawdown(const Case& data, Findings& findings) {
  for (const auto& [name, m] : data.materials) {
    const std::string path = "materials." + name + ".undrained_envelope";
    if (!m.slices.undrained_envelope || !findings.is_sound("materials." + name)) continue;
    const auto strength = material::find_slice_strength(m.model, m);
    if (!strength || strength->law || m.friction_angle == 0)
      findings.add(path,
                   "material '{}' has an undrained envelope but no friction angle in effective stresses, which a "
                   "drawdown starts from",
                   name);
  }
  if (!data.lem.drawdown || !findings.is_sound("analysis.methods") || !uses(data, Method::lem)) return;
  check_others(data, findings);
  const InitialWater& before = data.initial.water;
  if (before.pressure == InitialPressure::zero) {
    if (findings.is_sound("initial.pore_pressure"))
      findings.add("lem.drawdown",
                   "there is no water to draw down: give the water table before drawdown as [initial] pore_pressure = "
                   "\"water_table\", or as \"seepage\" with a pool");
    return;
  }
  if (findings.is_sound("lem.drawdown.method")) check_soils(data, findings);
  if (!check_water_table(data.lem.drawdown->water_table, "lem.drawdown.water_table", data.units().length, findings))
    return;
  // Pools of [[hydraulic]] are above this line: run::make_section() compares their levels.
  if (before.pressure == InitialPressure::water_table && data.hydraulics.empty() &&
      findings.is_sound("initial.water_table") && !before.water_table.empty())
    check_fall(before.water_table, data.lem.drawdown->water_table, data.units().length, findings);
}

// Checks of [[lem.surface]]: circles must cut the ground, and polylines must run from ground to ground through soil.

namespace {

using Point = std::array<double, 2>;

/// Tolerated distance of an end of a polyline from the ground, as a fraction of its width.
constexpr double end_slack = 1e-2;
/// Number of sampling points between the ends of a circle.
constexpr int places = 400;

void check_circle(const SlipSurface& s, const std::string& path, const SoilOutline& soil, Findings& findings) {
  const auto [xc, yc] = *s.centre;
  const double r = *s.radius, slack = soil.slack();
  const ShownUnit& length = soil.units().length;
  if (check_range(s.ends, path + ".ends", "places x", findings)) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (!soil.spans(s.ends[i]))
        return findings.add(path + ".ends", "an end of surface '{}', x = {}, is not on the ground, {}", s.name,
                            format_coordinate(s.ends[i], length), soil.write_span());
      if (std::abs(s.ends[i] - xc) > r + slack)
        return findings.add(path + ".ends",
                            "the end x = {} of surface '{}' is farther from the centre than its radius, {}",
                            format_coordinate(s.ends[i], length), s.name, format_value(r, length));
    }
    return;
  }
  if (!findings.is_sound(path)) return;
  const double from = std::max(xc - r, soil.left()), to = std::min(xc + r, soil.right());
  for (int i = 1; i < places; ++i) {
    const double x = from + (to - from) * i / places;
    const double low = yc - std::sqrt(std::max(0.0, r * r - (x - xc) * (x - xc)));
    if (from < to && low < soil.find_ground(x)) return;
  }
  findings.add(path, "the circle of surface '{}' lies outside the ground: nothing of its lower arc is in the soil",
               s.name);
}

void check_end(const SlipSurface& s, const Point& end, const std::string& path, const SoilOutline& soil,
               Findings& findings) {
  const ShownUnit& length = soil.units().length;
  if (!soil.spans(end[0]))
    return findings.add(path, "surface '{}' begins or ends at x = {}, outside the ground, {}", s.name,
                        format_coordinate(end[0], length), soil.write_span());
  // On a vertical step a surface may end at any level of it.
  const double hair = 1e-7 * (soil.right() - soil.left());
  double low = soil.find_ground(end[0]);
  for (const double x : {end[0] - hair, end[0] + hair})
    if (soil.spans(x)) low = std::min(low, soil.find_ground(x));
  const double above = end[1] - std::clamp(end[1], low, soil.find_ground(end[0]));
  if (std::abs(above) > end_slack * (s.points.back()[0] - s.points.front()[0]))
    findings.add(path, "the end {} of surface '{}' is {} {} the ground; a surface goes from ground to ground",
                 format_point(end, length), s.name, format_value(std::abs(above), length, 3),
                 above > 0 ? "above" : "below");
}

void check_polyline(const SlipSurface& s, const std::string& path, const SoilOutline& soil, Findings& findings) {
  const std::string points = path + ".points";
  const ShownUnit& length = soil.units().length;
  if (s.points.size() < 2)
    return findings.add(points, "surface '{}' has {} points; it needs at least 2", s.name, s.points.size());
  for (std::size_t i = 1; i < s.points.size(); ++i)
    if (s.points[i][0] <= s.points[i - 1][0])
      return findings.add(fmt::format("{}.{}", points, i),
                          "surface '{}' goes from x = {} to x = {}; its points run from left to right, x increasing",
                          s.name, format_coordinate(s.points[i - 1][0], length),
                          format_coordinate(s.points[i][0], length));
  check_end(s, s.points.front(), points + ".0", soil, findings);
  check_end(s, s.points.back(), fmt::format("{}.{}", points, s.points.size() - 1), soil, findings);
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const Point& p = s.points[i];
    const std::string at = fmt::format("{}.{}", points, i);
    if (!findings.is_sound(at)) continue;
    if (p[1] < soil.bottom() - soil.slack())
      findings.add(at, "the point {} of surface '{}' is below the soil, whose lowest level is {}",
                   format_point(p, length), s.name, format_coordinate(soil.bottom(), length));
    else if (i > 0 && i + 1 < s.points.size() && p[1] > soil.find_ground(p[0]) + soil.slack())
      findings.add(at, "the point {} of surface '{}' is above the ground", format_point(p, length), s.name);
  }
}

}  // namespace

void check_slip_surface(const SlipSurface& s, const std::string& path, const SoilOutline& soil, Findings& findings) {
  const bool has_circle = s.centre || s.radius, has_line = findings.places.is_given(path + ".points");
  if (has_circle == has_line)
    return findings.add(path, "surface '{}' {}; give 'centre' and 'radius' of a circle, or the 'points' of a polyline",
                        s.name, has_line ? "is a circle and a polyline" : "has no shape");
  if (has_line) {
    if (findings.places.is_given(path + ".ends"))
      findings.add(path + ".ends", "'ends' belongs to a circle; a polyline ends at its first and last point");
    return check_polyline(s, path, soil, findings);
  }
  if (!s.centre || !s.radius)
    return findings.add(path, "the circle of surface '{}' has no '{}'", s.name, s.centre ? "radius" : "centre");
  check_circle(s, path, soil, findings);
}

std::vector<SliceMethod> list_polyline_methods(const LimitEquilibrium& settings) {
  std::vector<SliceMethod> methods{SliceMethod::spencer, SliceMethod::morgenstern_price};
  for (const SliceMethod method : settings.methods)
    if (suits_polylines(method) && std::find(methods.begin(), methods.end(), method) == methods.end())
      methods.push_back(method);
  return methods;
}

}  // namespace talus::input
