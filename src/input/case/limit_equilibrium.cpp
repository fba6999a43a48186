// SPDX-License-Identifier: MIT
// Checks of [lem], [[lem.surface]], [[surcharge]] and [partial_factors]: surfaces and ranges must lie on the soil.
#include "input/case/limit_equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "input/case/checks.hpp"
#include "input/case/geometry.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

void describe(Visitor& v, SlipSurface& s) {
  v.key("name", s.name, plain().required().example(R"("A")"), "Name of the surface in tables and plots.");
  v.key("centre", s.centre, quantity("m").example("[30, 25]"), "Centre of a circle.");
  v.key("radius", s.radius, quantity("m").above(0).example("20"), "Radius of the circle.");
  v.key("ends", s.ends, quantity("m").example("[12, 32]"),
        "x of the two points on the ground between which the arc slides; if not given, those where circle and ground "
        "meet, the longest part of the soil between two of them.");
  v.key("points", s.points, quantity("m").example("[[8, 15], [20, 6], [32, 5]]"),
        "Instead of a circle: corners of a polyline from left to right. Its ends lie on the ground.");
}

void describe(Visitor& v, EntryExit& e) {
  v.key("exit", e.exit, quantity("m").example("[28, 36]"),
        "From which x to which x surfaces come out of the ground at the toe; empty: all of the ground.");
  v.key("entry", e.entry, quantity("m").example("[2, 14]"), "The same of where they begin at the crest.");
  v.key("exits", e.exits, plain().at_least(2).at_most(1000), "Exits in that range.");
  v.key("entries", e.entries, plain().at_least(2).at_most(1000), "Entries in that range.");
  v.key("depths", e.depths, plain().at_least(1).at_most(1000), "Circles through each pair, from flat to deep.");
}

void describe(Visitor& v, CentreGrid& g) {
  v.key("corners", g.corners, quantity("m").example("[[20, 16], [40, 36]]"),
        "Lower left and upper right corner of the grid of centres; empty: chosen from the ground.");
  v.key("columns", g.columns, plain().at_least(1).at_most(1000), "Centres side by side.");
  v.key("rows", g.rows, plain().at_least(1).at_most(1000), "Centres one above the other.");
  v.key("radii", g.radii, plain().at_least(1).at_most(1000), "Circles about each centre.");
  v.key("levels", g.levels, quantity("m").example("[0, 6]"),
        "Lowest and highest level of the deepest point of a circle; empty: from the base of the section to above the "
        "toe.");
}

void describe(Visitor& v, SurfaceWindow& w) {
  v.key("name", w.name, plain().required().example(R"("A")"), "Name of the window in messages and pictures.");
  v.key("points", w.points, quantity("m").example("[[10, 3], [18, 4]]"), "A point or a polyline.");
  v.key("box", w.box, quantity("m").example("[[10, 2], [18, 4]]"), "Instead of points: two opposite corners of a box.");
}

void describe(Visitor& v, ExcludedArea& e) {
  v.key("name", e.name, plain().required().example(R"("cellar")"), "Name of the area in messages and pictures.");
  v.key("points", e.points, quantity("m").required().example("[[20, 2], [28, 2], [28, 8], [20, 8]]"),
        "Corners of its polygon, in order. A surface may run along its sides.");
}

void describe(Visitor& v, BlockSearch& b) {
  v.key(
      "along", b.along, plain().example(R"("seam")"),
      "Region, material or [[geometry.line]] that the surfaces follow, instead of windows: in a layer from its bottom "
      "to its top, along a line in the soil above it.");
  v.key("active", b.active, quantity("deg").at_least(1).at_most(89),
        "From which to which inclination the surface rises at its upper end, measured from the horizontal. In "
        "drawings of a slope that falls to the left this is the right projection angle.");
  v.key("passive", b.passive, quantity("deg").at_least(-60).at_most(80),
        "The same at the lower end, where it rises to the ground; negative: it falls. A vertex on the ground is an "
        "end and has no such line.");
  v.key("angles", b.angles, plain().at_least(1).at_most(100), "Inclinations in each of these ranges.");
  v.key("surfaces", b.surfaces, plain().at_least(10).at_most(1000000),
        "About so many surfaces are tried, evenly over windows and inclinations; the best are then optimised within "
        "them.");
  v.tables("window", b.windows, 0,
           "Each surface has a vertex in each window, two windows at least and eight at most. The vertices are "
           "ordered by x.");
}

void describe(Visitor& v, TangentCircles& t) {
  v.key("levels", t.levels, quantity("m").example("[2, 4]"),
        "Level of the deepest point of every circle: one number, or from where to where.");
  v.key("layer", t.layer, plain().example(R"("clay")"),
        "Instead of levels: region, material or [[geometry.line]] that every circle touches from above.");
  v.key("side", t.side, plain(), "Which side of the layer.");
}

void describe(Visitor& v, TensionCrack& t) {
  v.key("depth", t.depth, quantity("m").at_least(0),
        "Depth of a vertical crack at the upper end of every surface; 0: none.");
  v.key("water", t.water, quantity("m").at_least(0), "Height of the water in it, above its bottom.");
  v.key("limit", t.limit, plain(),
        "The crack ends where the soil would no longer be in tension beside it: Rankine's active stress, less the "
        "pressure of the water in the crack, is zero there (2c/γ·tan(45° + φ/2) where all is dry). With water in it "
        "each surface has this depth or the given one, whichever is weaker. false: it is as deep as `depth`, as a "
        "joint that was measured.");
}

void describe(Visitor& v, Drawdown& d) {
  v.key("method", d.method, plain().required().example(R"("three_stage")"), "Where the strength after it comes from.");
  v.key("water_table", d.water_table, quantity("m").required().example("[[0, 7], [60, 7]]"),
        "The water table after drawdown, from left to right, as [initial] water_table: level beyond its ends, and "
        "standing water where it is above the ground.");
}

void describe(Visitor& v, LimitEquilibrium& l) {
  v.key("methods", l.methods, plain(), "Methods of slices.");
  v.key("slices", l.slices, plain().at_least(5).at_most(2000), "Slices of a surface, about.");
  v.key("search", l.search, plain(), "How the critical circle is searched for.");
  v.key("composite", l.composite, plain(),
        "Circles that reach the bottom of the section continue along it; otherwise they are rejected.");
  v.key("noncircular", l.noncircular, plain(), "Continue from the critical circle to the critical polyline.");
  v.key("vertices", l.vertices, plain().at_least(3).at_most(100), "Corners of that polyline.");
  v.key("minima", l.minima, plain().at_least(1).at_most(50), "Distinct local minima that are shown.");
  v.key("seed", l.seed, plain().at_least(0),
        "Another number starts the search elsewhere: entries, exits and blocks along layers move by random parts of "
        "the distance to their neighbours. A minimum that moves with it was not found; 0: they stand evenly.");
  v.key("smallest_depth", l.smallest_depth, quantity("m").at_least(0).example("1"),
        "Surfaces whose sliding mass is nowhere deeper than this are refused; if not given, the search refuses those "
        "below a fiftieth of the ground's relief, or below 0.5 m where that is less.");
  v.key("smallest_area", l.smallest_area, quantity("m2").above(0).example("5"),
        "Surfaces with a smaller area of the sliding mass are refused.");
  v.key("smallest_weight", l.smallest_weight, quantity("kN/m").above(0).example("100"),
        "Surfaces with a lighter sliding mass, per length of the slope, are refused.");
  v.key("slides", l.slides, plain(),
        "Only surfaces that slide to this side; the exit lies there. It serves a section with two slopes, such as a "
        "dam.");
  v.key("impenetrable", l.impenetrable, plain().example(R"(["rock"])"),
        "Materials that no surface enters: circles and polylines that would cut below their top follow it "
        "in the soil above.");
  v.key("smallest_m_alpha", l.smallest_m_alpha, plain().at_least(0).below(1),
        "A surface with a smaller m_α at one of its slices fails the checks.");
  v.key("most_tension", l.most_tension, plain().at_least(0).at_most(1),
        "A surface with tensile effective normal forces on more than this fraction of its length fails the checks.");
  v.key("most_thrust_outside", l.most_thrust_outside, plain().at_least(0).at_most(1),
        "A surface with more than this fraction of its interslice forces outside the sliding mass fails the checks "
        "(Spencer and Morgenstern–Price).");
  v.key("reject", l.reject, plain(),
        "Surfaces that fail these checks are refused and counted by their reason; false: they only bring a warning.");
  v.key(
      "largest_lambda", l.largest_lambda, plain().above(0),
      "A solution of Spencer or Morgenstern–Price with a larger λ has no factor, whatever `reject` is: its interslice "
      "forces are steeper than the strength of soil allows.");
  v.key("smallest_lambda", l.smallest_lambda, plain().at_most(0),
        "Surfaces with a smaller λ have no factor either: the interslice shear would oppose sliding.");
  v.key("yield_acceleration", l.yield_acceleration, plain(),
        "Find the horizontal acceleration with factor 1 of the critical surfaces; not with [lem.drawdown].");
  v.key("referee", l.referee, plain(),
        "Hold every factor against limit analysis (ψ = φ, tension up to the apex): a factor below the lower bound "
        "or above the upper bound never governs. Beside supports whose force is not axial (piles, bolts, walls) it is "
        "false.");
  v.table("entry_exit", l.entry_exit, "Where search = \"entry_exit\" looks.");
  v.table("grid", l.grid, "Where search = \"grid\" looks.");
  v.table("block", l.block, "Where search = \"block\" looks.");
  v.optional_table("tangent", l.tangent,
                   "Circles are only tried where they are tangent to a level or layer. No polyline is searched then.");
  v.tables("exclude", l.excluded, 0, "An area that no surface enters.");
  v.tables("through", l.passages, 0, "A window through which every surface passes: a polyline that it cuts, or a box.");
  v.table("tension_crack", l.crack, "A crack at the crest.");
  v.optional_table("drawdown", l.drawdown,
                   "Rapid drawdown: the water that [initial] names falls to another level, while soils with an "
                   "`undrained_envelope` (or a `b_bar`) do not drain. Every factor is then that after drawdown.");
  v.tables("surface", l.surfaces, 0,
           "A slip surface of your choice, by the methods of `methods`: a circle (centre and radius) or a polyline.");
}

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
