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
void describe(Visitor& v, Circle& r);

struct SlipSurface {
  SliceMethod method = SliceMethod::spencer;
  std::string title;
  bool circular = false;
  std::optional<double> factor;  ///< nullopt if there is no admissible solution
  std::optional<Circle> circle;
  std::vector<Point> points;        ///< [m]
  std::optional<std::string> name;  ///< name in the case, for a given surface
};
void describe(Visitor& v, SlipSurface& r);

/// Admissibility checks of a surface.
struct SurfaceChecks {
  double smallest_m_alpha = 0, tensile_share = 0, thrust_outside = 0, residual = 0;
  std::string refusal;  ///< reason for which a search would reject the surface; empty if admissible
};
void describe(Visitor& v, SurfaceChecks& r);

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
void describe(Visitor& v, SliceTable& r);

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
void describe(Visitor& v, DrawnSurface& r);

/// Limit that governs the force of a support.
enum class SupportLimit {
  tension,
  pull_out,
  stripping,
  prestress,
  lateral,
  shear,
  embedment,
  rotation,
  one_hinge,
  two_hinges
};
template <>
inline constexpr auto words<SupportLimit> = std::array{"tension", "pull_out",  "stripping", "prestress", "lateral",
                                                       "shear",   "embedment", "rotation",  "one_hinge", "two_hinges"};

/// Force of a support where a surface crosses it, per metre of slope.
struct SupportForce {
  std::string support;              ///< name in the case
  std::string kind;                 ///< word of the case
  int row = 1;                      ///< from the top of the pattern
  bool is_active = false;           ///< the factor does not divide the force
  Point head{}, end{}, crossing{};  ///< [m]
  double distance = 0;              ///< of the crossing from the head [m]
  double resistance = 0;            ///< [N/m]
  double force = 0;  ///< on the sliding mass: the resistance, divided by a factor above 1 if passive [N/m]
  std::optional<double> required;  ///< force of a passive support for equilibrium at a factor below 1 [N/m]
  Point direction{};               ///< of the force on the sliding mass
  std::optional<double> tension, pull_out, stripping;  ///< limits; nullopt: none [N/m]
  SupportLimit limit = SupportLimit::tension;          ///< the least of them
};
void describe(Visitor& v, SupportForce& r);

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
void describe(Visitor& v, CriticalSurface& r);

enum class SearchKind { entry_exit, grid, block };
template <>
inline constexpr auto words<SearchKind> = std::array{"entry_exit", "grid", "block"};

/// Grid of the centres of trial circles.
struct GridRange {
  Point from{}, to{};  ///< [m]
  int columns = 0, rows = 0, radii = 0;
  std::optional<Point> levels;  ///< lowest and highest level of the horizontal tangents [m]
};
void describe(Visitor& v, GridRange& r);

/// Ranges of the search: entry and exit points, or the grid of centres.
struct SearchRanges {
  std::optional<Point> exit, entry;  ///< range of x [m]
  std::optional<int> exits, entries, depths;
  std::optional<GridRange> grid;
};
void describe(Visitor& v, SearchRanges& r);

/// A window, an excluded area, or the corners of a box.
struct SearchShape {
  std::string name;
  std::vector<Point> points;  ///< [m]
  bool is_box = false;        ///< `points` are its lower left and upper right corner
};
void describe(Visitor& v, SearchShape& r);

/// Blocks that were searched.
struct BlockRange {
  std::optional<std::string> along;  ///< layer or line that they follow; else windows
  std::vector<SearchShape> windows;
  Point active{}, passive{};  ///< ranges of the inclination of the upper and the lower end [rad]
  int angles = 0;             ///< number of inclinations in each range
};
void describe(Visitor& v, BlockRange& r);

/// Levels or layer that every circle of the search touches.
struct TangentRange {
  std::optional<Point> levels;  ///< lowest and highest [m]
  std::optional<std::string> layer;
  bool is_top = true;  ///< side of the layer
};
void describe(Visitor& v, TangentRange& r);

/// Restrictions of the slip surfaces of a search.
struct SearchRestrictions {
  std::optional<BlockRange> block;
  std::optional<TangentRange> tangent;
  std::vector<SearchShape> excluded, through;
  std::vector<std::string> impenetrable;
  std::optional<bool> slides_left;
  std::optional<double> smallest_area, smallest_weight;  ///< of the sliding mass [m²], [N/m]
};
void describe(Visitor& v, SearchRestrictions& r);

/// A critical surface at a limit of the search ranges.
struct LimitHit {
  std::string method;  ///< title of the method of slices
  std::string limit;   ///< such as "the critical circle …"
};
void describe(Visitor& v, LimitHit& r);

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
void describe(Visitor& v, SliceSearch& r);

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
void describe(Visitor& v, SliceResult& r);

/// Smallest factor by centre of the trial circles, on a regular grid.
struct FactorMap {
  Point from{}, to{};  ///< [m]
  int columns = 0, rows = 0;
  std::vector<std::optional<double>> factor;  ///< row by row; nullopt where no circle was admissible
};
void describe(Visitor& v, FactorMap& r);

/// Factors of all trial circles.
struct SliceTrials {
  std::vector<std::string> methods;
  std::vector<std::vector<double>> trials;  ///< centre x, y, radius, x range [m], factor by method
  std::map<std::string, FactorMap> maps;    ///< by method
};
void describe(Visitor& v, SliceTrials& r);

/// lem.json: the results that a resumed run reads instead of computing them again, and the trials for the report.
struct SliceFile {
  std::string input_hash;
  SliceResult summary;
  std::optional<SliceTrials> trials;
};
void describe(Visitor& v, SliceFile& r);

}  // namespace talus::results
