// SPDX-License-Identifier: MIT
#pragma once
// Results of limit equilibrium: critical surfaces with their slices, statistics of the search, and the trial surfaces.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/methods.hpp"
#include "results/about.hpp"
#include "results/bounds.hpp"
#include "results/water.hpp"

namespace talus::results {

template <class Name, std::size_t N>
constexpr std::array<const char*, N> list_words(const std::array<Name, N>& names) {
  std::array<const char*, N> list{};
  for (std::size_t i = 0; i < N; ++i) list[i] = names[i].word;
  return list;
}
template <>
inline constexpr auto words<SliceMethod> = list_words(slice_methods);
template <>
inline constexpr auto words<DrawdownMethod> = list_words(drawdown_methods);

struct Circle {
  Point centre{};     ///< [m]
  double radius = 0;  ///< [m]
};
void describe(auto& v, As<Circle> auto& r) {
  v.key("centre", r.centre, {"m", "centre"});
  v.key("radius", r.radius, {"m", "radius"});
}

struct SlipSurface {
  SliceMethod method = SliceMethod::spencer;
  std::string title;
  bool circular = false;
  std::optional<double> factor;  ///< nullopt if there is no admissible solution
  std::optional<Circle> circle;
  std::vector<Point> points;        ///< [m]
  std::optional<std::string> name;  ///< name in the case, for a given surface
};
void describe(auto& v, As<SlipSurface> auto& r) {
  v.key("method", r.method, {"", "method"});
  v.key("title", r.title, {"", "name of the method"});
  v.key("circular", r.circular, {"", "whether it is a circle"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("circle", r.circle, {"", "the circle"});
  v.key("points", r.points, {"m", "its points"});
  v.maybe("name", r.name, {"", "name in the case"});
}

/// Admissibility checks of a surface.
struct SurfaceChecks {
  double smallest_m_alpha = 0, tensile_share = 0, thrust_outside = 0, residual = 0;
  std::string refusal;  ///< reason for which a search would reject the surface; empty if admissible
};
void describe(auto& v, As<SurfaceChecks> auto& r) {
  v.key("smallest_m_alpha", r.smallest_m_alpha, {"", "smallest m_α", can_be_nan});
  v.key("tensile_share", r.tensile_share, {"", "share of the base in tension"});
  v.key("thrust_outside", r.thrust_outside, {"", "share of the sides with the thrust outside the mass"});
  v.key("residual", r.residual, {"", "what is left of forces and moments, over the weight"});
  v.key("refusal", r.refusal, {"", "why a search would refuse it"});
}

/// The slices of a surface, one column for each quantity.
struct SliceTable {
  std::vector<double> left, right;           ///< x [m]
  std::vector<Point> base_left, base_right;  ///< [m]
  std::vector<double> top_left, top_right;   ///< y [m]
  std::vector<std::string> soil;             ///< at the base
  std::vector<double> alpha, length, weight, surface_load, surface_thrust, earthquake, pore_pressure, cohesion,
      root_cohesion, suction_strength, tan_friction, normal, shear, m_alpha, normal_right, shear_right, thrust_right;
  std::size_t size() const { return left.size(); }
};
void describe(auto& v, As<SliceTable> auto& r) {
  v.key("left", r.left, {"m", "x of the left side"});
  v.key("right", r.right, {"m", "x of the right side"});
  v.key("base_left", r.base_left, {"m", "left end of the base"});
  v.key("base_right", r.base_right, {"m", "right end of the base"});
  v.key("top_left", r.top_left, {"m", "y of the ground at the left side"});
  v.key("top_right", r.top_right, {"m", "y of the ground at the right side"});
  v.key("soil", r.soil, {"", "soil at the base"});
  v.key("alpha", r.alpha, {"rad", "inclination of the base"});
  v.key("length", r.length, {"m", "length of the base"});
  v.key("weight", r.weight, {"N/m", "weight"});
  v.key("surface_load", r.surface_load, {"N/m", "vertical load on the ground"});
  v.key("surface_thrust", r.surface_thrust, {"N/m", "horizontal load on the ground"});
  v.key("earthquake", r.earthquake, {"N/m", "horizontal force of the earthquake"});
  v.key("pore_pressure", r.pore_pressure, {"Pa", "pore pressure at the base"});
  v.key("cohesion", r.cohesion, {"Pa", "cohesion at the base"});
  v.key("root_cohesion", r.root_cohesion, {"Pa", "cohesion of roots"});
  v.key("suction_strength", r.suction_strength, {"Pa", "strength by suction"});
  v.key("tan_friction", r.tan_friction, {"", "tangent of the friction angle"});
  v.key("normal", r.normal, {"N/m", "normal force on the base", can_be_nan});
  v.key("shear", r.shear, {"N/m", "shear force on the base", can_be_nan});
  v.key("m_alpha", r.m_alpha, {"", "m_α", can_be_nan});
  v.key("normal_right", r.normal_right, {"N/m", "normal force on the right side", can_be_nan});
  v.key("shear_right", r.shear_right, {"N/m", "shear force on the right side", can_be_nan});
  v.key("thrust_right", r.thrust_right, {"m", "y of the thrust on the right side", can_be_nan});
}

/// Strength that governs the base of a slice after a drawdown.
enum class Drainage { drained, undrained };
template <>
inline constexpr auto words<Drainage> = std::array{"drained", "undrained"};

/// Stages of a rapid drawdown for one surface. The lists are by slice and filled by the total-stress methods only.
struct DrawnSurface {
  std::optional<double> factor_before;          ///< before the drawdown; nullopt without a solution
  std::optional<double> undrained_factor;       ///< second stage of the three-stage method
  std::vector<double> normal, shear;            ///< effective normal and shear stress on the base before it [Pa]
  std::vector<std::optional<double>> strength;  ///< undrained strength [Pa]; nullopt in soil that drains
  std::vector<Drainage> counts;                 ///< governing strength
};
void describe(auto& v, As<DrawnSurface> auto& r) {
  v.key("factor_before", r.factor_before, {"", "factor of safety before drawdown"});
  v.maybe("undrained_factor", r.undrained_factor, {"", "factor of safety of the second stage of three"});
  v.key("normal", r.normal, {"Pa", "effective normal stress on the base before drawdown"});
  v.key("shear", r.shear, {"Pa", "shear stress on the base before drawdown"});
  v.key("strength", r.strength, {"Pa", "undrained strength of the base"});
  v.key("counts", r.counts, {"", "which strength of the base counts"});
}

/// Limit that governs the force of a support.
enum class SupportLimit { tension, pull_out, stripping, prestress, lateral, shear };
template <>
inline constexpr auto words<SupportLimit> =
    std::array{"tension", "pull_out", "stripping", "prestress", "lateral", "shear"};

/// Force of a support where a surface crosses it, per metre of slope.
struct SupportForce {
  std::string support;              ///< name in the case
  std::string kind;                 ///< word of the case
  int row = 1;                      ///< from the top of the pattern
  bool is_active = false;           ///< the factor does not divide the force
  Point head{}, end{}, crossing{};  ///< [m]
  double distance = 0;              ///< of the crossing from the head [m]
  double resistance = 0;            ///< [N/m]
  double force = 0;                 ///< on the sliding mass: the resistance, divided by the factor if passive [N/m]
  Point direction{};                ///< of the force on the sliding mass
  std::optional<double> tension, pull_out, stripping;  ///< limits; nullopt: none [N/m]
  SupportLimit limit = SupportLimit::tension;          ///< the least of them
};
void describe(auto& v, As<SupportForce> auto& r) {
  v.key("support", r.support, {"", "name of the support"});
  v.key("kind", r.kind, {"", "kind of the support"});
  v.key("row", r.row, {"", "row from the top of the pattern"});
  v.key("is_active", r.is_active, {"", "whether the force is a load, which the factor does not divide"});
  v.key("head", r.head, {"m", "head of the bar"});
  v.key("end", r.end, {"m", "end of the bar"});
  v.key("crossing", r.crossing, {"m", "where the surface crosses the bar"});
  v.key("distance", r.distance, {"m", "distance of the crossing from the head"});
  v.key("resistance", r.resistance, {"N/m", "resistance of the bar there, per metre of slope"});
  v.key("force", r.force, {"N/m", "force on the sliding mass, per metre of slope"});
  v.key("direction", r.direction, {"", "unit vector of that force"});
  v.key("tension", r.tension, {"N/m", "tensile strength"});
  v.key("pull_out", r.pull_out, {"N/m", "pull-out resistance behind the surface"});
  v.key("stripping", r.stripping, {"N/m", "resistance of head and bond in front of the surface"});
  v.key("limit", r.limit, {"", "which limit governs"});
}

/// A slip surface with all its results.
struct CriticalSurface {
  SlipSurface surface;
  std::optional<double> lambda;  ///< for Spencer and Morgenstern–Price only
  double correction = 1;         ///< f₀ of corrected Janbu
  double area = 0;               ///< [m²]
  double depth = 0;              ///< largest depth [m]
  std::optional<double> crack;   ///< depth of the dry tension crack added by the search [m]
  std::string volume_note = "m³ per metre of slope";
  bool slides_left = false;
  std::optional<double> yield_acceleration;           ///< k_y, over g
  std::optional<DrawnSurface> drawdown;               ///< with rapid drawdown; `surface.factor` is then that after it
  std::optional<std::vector<SupportForce>> supports;  ///< those that it crosses; nullopt in a case without supports
  SurfaceChecks checks;
  std::optional<Verdict> verdict;  ///< by limit analysis; nullopt if no bounds apply
  SliceTable slices;
  std::vector<std::string> warnings;
};
void describe(auto& v, As<CriticalSurface> auto& r) {
  describe(v, r.surface);
  v.key("lambda", r.lambda, {"", "λ, the inclination of the forces between slices"});
  v.key("correction", r.correction, {"", "f₀ of Janbu"});
  v.key("area", r.area, {"m2", "area of the mass"});
  v.key("depth", r.depth, {"m", "greatest depth"});
  v.maybe("crack", r.crack, {"m", "depth of the dry tension crack that the search added"});
  v.key("volume_note", r.volume_note, {"", "meaning of the area"});
  v.key("slides_left", r.slides_left, {"", "whether it slides towards smaller x"});
  v.key("yield_acceleration", r.yield_acceleration, {"", "yield acceleration over gravity"});
  v.maybe("drawdown", r.drawdown, {"", "rapid drawdown; the factor is after it"});
  v.maybe("supports", r.supports, {"", "forces of the supports that it crosses"});
  v.key("checks", r.checks, {"", "checks of admissibility"});
  v.maybe("verdict", r.verdict, {"", "what limit analysis proves of the factor"});
  v.key("slices", r.slices, {"", "its slices"});
  v.key("warnings", r.warnings, {"", "warnings"});
}

enum class SearchKind { entry_exit, grid, block };
template <>
inline constexpr auto words<SearchKind> = std::array{"entry_exit", "grid", "block"};

/// Grid of the centres of trial circles.
struct GridRange {
  Point from{}, to{};  ///< [m]
  int columns = 0, rows = 0, radii = 0;
  std::optional<Point> levels;  ///< lowest and highest level of the horizontal tangents [m]
};
void describe(auto& v, As<GridRange> auto& r) {
  v.key("from", r.from, {"m", "one corner"});
  v.key("to", r.to, {"m", "other corner"});
  v.key("columns", r.columns, {"", "columns"});
  v.key("rows", r.rows, {"", "rows"});
  v.key("radii", r.radii, {"", "radii at each centre"});
  v.key("levels", r.levels, {"m", "lowest and highest tangent"});
}

/// Ranges of the search: entry and exit points, or the grid of centres.
struct SearchRanges {
  std::optional<Point> exit, entry;  ///< range of x [m]
  std::optional<int> exits, entries, depths;
  std::optional<GridRange> grid;
};
void describe(auto& v, As<SearchRanges> auto& r) {
  v.maybe("exit", r.exit, {"m", "where surfaces leave the ground"});
  v.maybe("entry", r.entry, {"m", "where surfaces enter the ground"});
  v.maybe("exits", r.exits, {"", "exits"});
  v.maybe("entries", r.entries, {"", "entries"});
  v.maybe("depths", r.depths, {"", "circles between an entry and an exit"});
  v.maybe("grid", r.grid, {"", "grid of centres"});
}

/// A window, an excluded area, or the corners of a box.
struct SearchShape {
  std::string name;
  std::vector<Point> points;  ///< [m]
  bool is_box = false;        ///< `points` are its lower left and upper right corner
};
void describe(auto& v, As<SearchShape> auto& r) {
  v.key("name", r.name, {"", "name in the case"});
  v.key("points", r.points, {"m", "a point, a polyline, corners of a polygon, or two corners of a box"});
  v.key("is_box", r.is_box, {"", "whether the points are two corners of a box"});
}

/// Blocks that were searched.
struct BlockRange {
  std::optional<std::string> along;  ///< layer or line that they follow; else windows
  std::vector<SearchShape> windows;
  Point active{}, passive{};  ///< ranges of the inclination of the upper and the lower end [rad]
  int angles = 0;             ///< number of inclinations in each range
};
void describe(auto& v, As<BlockRange> auto& r) {
  v.maybe("along", r.along, {"", "layer or line that the surfaces follow"});
  v.key("windows", r.windows, {"", "windows, each with a vertex of every surface"});
  v.key("active", r.active, {"rad", "least and greatest inclination of the upper end"});
  v.key("passive", r.passive, {"rad", "least and greatest inclination of the lower end"});
  v.key("angles", r.angles, {"", "inclinations in each range"});
}

/// Levels or layer that every circle of the search touches.
struct TangentRange {
  std::optional<Point> levels;  ///< lowest and highest [m]
  std::optional<std::string> layer;
  bool is_top = true;  ///< side of the layer
};
void describe(auto& v, As<TangentRange> auto& r) {
  v.maybe("levels", r.levels, {"m", "lowest and highest level of the deepest point of circles"});
  v.maybe("layer", r.layer, {"", "layer or line that circles touch"});
  v.key("is_top", r.is_top, {"", "whether they touch its top; else its bottom"});
}

/// Restrictions of the slip surfaces of a search.
struct SearchRestrictions {
  std::optional<BlockRange> block;
  std::optional<TangentRange> tangent;
  std::vector<SearchShape> excluded, through;
  std::vector<std::string> impenetrable;
  std::optional<bool> slides_left;
  std::optional<double> smallest_area, smallest_weight;  ///< of the sliding mass [m²], [N/m]
};
void describe(auto& v, As<SearchRestrictions> auto& r) {
  v.maybe("block", r.block, {"", "polylines of a search for blocks"});
  v.maybe("tangent", r.tangent, {"", "what every circle is tangent to"});
  v.key("excluded", r.excluded, {"", "areas that no surface enters"});
  v.key("through", r.through, {"", "windows that every surface passes"});
  v.key("impenetrable", r.impenetrable, {"", "materials whose top surfaces follow"});
  v.maybe("slides_left", r.slides_left, {"", "whether only masses that slide towards smaller x count; else larger x"});
  v.maybe("smallest_area", r.smallest_area, {"m2", "smallest area of a sliding mass"});
  v.maybe("smallest_weight", r.smallest_weight, {"N/m", "smallest weight of a sliding mass"});
}

/// A critical surface at a limit of the search ranges.
struct LimitHit {
  std::string method;  ///< title of the method of slices
  std::string limit;   ///< such as "the critical circle …"
};
void describe(auto& v, As<LimitHit> auto& r) {
  v.key("method", r.method, {"", "name of the method"});
  v.key("limit", r.limit, {"", "which limit"});
}

struct SliceSearch {
  SearchKind kind = SearchKind::entry_exit;
  long tried = 0;                                              ///< number of trial circles
  std::map<std::string, std::map<std::string, long>> refused;  ///< number of rejected circles by method and reason
  std::vector<LimitHit> limit_hits;
  SearchRanges ranges;
  std::optional<SearchRestrictions> restrictions;  ///< by keys of the case; nullopt without them
  double smallest_depth = 0;                       ///< smallest depth of a sliding mass that counts [m]
  double seconds = 0, circles_per_second = 0;
};
void describe(auto& v, As<SliceSearch> auto& r) {
  v.key("kind", r.kind, {"", "how circles were chosen"});
  v.key("tried", r.tried, {"", "circles that were tried"});
  v.key("refused", r.refused, {"", "refused surfaces by method and reason"});
  v.key("limits", r.limit_hits, {"", "critical surfaces at a limit of the search"});
  v.key("ranges", r.ranges, {"", "where it looked"});
  v.maybe("restrictions", r.restrictions, {"", "which surfaces the case asked for"});
  v.key("smallest_depth", r.smallest_depth, {"m", "smallest depth of a mass that it took"});
  v.key("seconds", r.seconds, {"s", "seconds"});
  v.key("circles_per_second", r.circles_per_second, {"1/s", "circles per second"});
}

/// "lem" of summary.json.
struct SliceResult {
  std::optional<std::string> error;  ///< why LEM gave no result
  std::vector<std::string> warnings;
  std::vector<SliceMethod> methods;
  int slices = 0;  ///< number of slices of a surface
  std::optional<DrawdownMethod> drawdown;
  std::vector<CriticalSurface> critical, noncircular, given;
  std::map<std::string, std::vector<SlipSurface>> minima;  ///< local minima by method
  std::optional<Referee> referee;                          ///< nullopt if no bounds were requested
  std::optional<SliceSearch> search;
  std::optional<std::string> trials_file;
  double seconds = 0;
};
void describe(auto& v, As<SliceResult> auto& r) {
  v.maybe("error", r.error, {"", "why there is no answer"});
  v.key("warnings", r.warnings, {"", "warnings"});
  v.key("methods", r.methods, {"", "methods of slices"});
  v.key("slices", r.slices, {"", "slices of a surface"});
  v.maybe("drawdown", r.drawdown, {"", "method of rapid drawdown; factors are after it"});
  v.key("critical", r.critical, {"", "critical circles"});
  v.key("noncircular", r.noncircular, {"", "critical polylines"});
  v.key("given", r.given, {"", "surfaces that the case gives"});
  v.key("minima", r.minima, {"", "local minima by method"});
  v.maybe("referee", r.referee, {"", "limit analysis of the soil of limit equilibrium"});
  v.maybe("search", r.search, {"", "what the search did"});
  v.maybe("trials_file", r.trials_file, {"", "file of the trials"});
  v.key("seconds", r.seconds, {"s", "seconds"});
}

/// Smallest factor by centre of the trial circles, on a regular grid.
struct FactorMap {
  Point from{}, to{};  ///< [m]
  int columns = 0, rows = 0;
  std::vector<std::optional<double>> factor;  ///< row by row; nullopt where no circle was admissible
};
void describe(auto& v, As<FactorMap> auto& r) {
  v.key("from", r.from, {"m", "one corner"});
  v.key("to", r.to, {"m", "other corner"});
  v.key("columns", r.columns, {"", "columns"});
  v.key("rows", r.rows, {"", "rows"});
  v.key("factor", r.factor, {"", "smallest factor, row by row"});
}

/// Factors of all trial circles.
struct SliceTrials {
  std::vector<std::string> methods;
  std::vector<std::vector<double>> trials;  ///< centre x, y, radius, x range [m], factor by method
  std::map<std::string, FactorMap> maps;    ///< by method
};
void describe(auto& v, As<SliceTrials> auto& r) {
  v.key("methods", r.methods, {"", "methods of slices"});
  v.key("trials", r.trials, {"", "centre x, y, radius, from, to [m], and the factor by each method"});
  v.key("maps", r.maps, {"", "smallest factor over the centres"});
}

/// lem.json: the results that a resumed run reads instead of computing them again, and the trials for the report.
struct SliceFile {
  std::string input_hash;
  SliceResult summary;
  std::optional<SliceTrials> trials;
};
void describe(auto& v, As<SliceFile> auto& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("summary", r.summary, {"", "limit equilibrium"});
  v.merge("trials", r.trials);
}

}  // namespace talus::results
