// SPDX-License-Identifier: MIT
#pragma once
// The search for the critical slip surface.

#include <array>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "base/progress.hpp"
#include "lem/section/slope.hpp"
#include "lem/slices/solve.hpp"
#include "lem/slices/wedge_mechanism.hpp"

namespace talus::lem {

// The factor of one surface after another by one method, with memory that is used again. One per thread.

/// A search may take minutes and keeps nothing before its end. Throws Error (interrupted).
inline void throw_if_search_is_interrupted(bool ends_at_signal) {
  if (ends_at_signal && is_interrupted())
    throw Error(ExitCode::interrupted, "interrupted while slip surfaces were searched");
}

struct OptimisedSurface {
  Surface surface;
  double factor = 0;  ///< Evaluator::refused when nothing was found
  int evaluations = 0;
};

class Evaluator {
 public:
  Evaluator(const Slope& slope, Method method, const Checks& checks, int slices, bool ends_at_signal = false)
      : slope_(&slope), method_(method), checks_(checks), slices_(slices), ends_at_signal_(ends_at_signal) {
    checks_.most_below_wedges = std::numeric_limits<double>::infinity();
    strict_ = checks;
    if (checks.reject && is_rigorous(method)) most_below_wedges_ = 0.95 * checks.most_below_wedges;
  }

  /// F; `refused` for an invalid surface or one without a factor. A polyline below the wedge mechanism of its base has
  /// a value above F that grows with the distance, so that a minimiser returns to those that are not. That is computed
  /// only below the smallest factor that passed so far. Throws Error (interrupted) where asked to.
  double operator()(const Surface& surface);
  /// Returns true where the factor of a surface passes all checks, that of wedges included.
  bool passes_all_checks(const Surface& surface);
  /// The surface with the smallest factor so far that is not below its mechanism.
  const OptimisedSurface& passing() const { return passing_; }
  /// From here on values below the mechanism grow fast. A minimiser returns from there at once, but does not follow the
  /// border between the two, which it does while they grow slowly.
  void steepen() { penalty_ = 4; }
  int count() const { return count_; }
  const Slope& slope() const { return *slope_; }
  Method method() const { return method_; }

  static constexpr double refused = 1e6;  ///< larger than any factor, and finite for the minimisers

 private:
  const Slope* slope_;
  Method method_;
  Checks checks_, strict_;  ///< without the check of wedges, and with it
  /// Slightly less than the check allows, which the result of a minimiser then passes.
  double most_below_wedges_ = std::numeric_limits<double>::infinity();
  int slices_;
  bool ends_at_signal_;
  CutSurface cut_;
  WedgeMechanism wedges_;
  int count_ = 0;
  double penalty_ = 1.5;
  OptimisedSurface passing_{{}, refused, 0};
};

/// Centres on a grid, and radii by the elevation of the deepest point.
struct GridSearch {
  Point from{}, to{};           ///< corners of the grid of centres [m]; equal: chosen from the ground
  int columns = 20, rows = 20;  ///< centres
  int radii = 11;
  std::optional<double> lowest, highest;  ///< elevations that the deepest points of the circles lie between [m]
};

/// Circles through an entry and an exit on the ground, with several depths each. Both ranges empty (their ends equal):
/// through any two of exits + entries points of the whole ground, sliding to the lower one.
struct EntryExitSearch {
  std::array<double, 2> exit{};   ///< range of x at the toe [m]
  std::array<double, 2> entry{};  ///< range of x at the crest [m]
  int exits = 25, entries = 25, depths = 15;
};

enum class SearchKind { entry_exit, grid };

struct SearchOptions {
  SearchKind kind = SearchKind::entry_exit;
  std::optional<GridSearch> grid;             ///< not given: chosen from the ground
  std::optional<EntryExitSearch> entry_exit;  ///< not given: the whole ground, both directions
  int slices = 50;
  std::vector<Method> methods{Method::bishop, Method::spencer};
  Checks checks;
  bool composite = false;        ///< circles may be cut level at the base
  bool optimise_circle = true;   ///< local optimisation from the best local minima
  bool optimise_surface = true;  ///< and of a non-circular surface from the critical circle
  int vertices = 12;             ///< of the non-circular surface
  int kept_minima = 5;           ///< local minima shown
  /// Otherwise a searched mass is somewhere deeper than a fiftieth of the ground's relief, or than 0.5 m: at the edge
  /// of a load, and in soil without cohesion, ever smaller ones have ever smaller factors.
  bool finds_skins = false;
  /// 0: entries, exits and blocks stand where the ground wants them; another number moves each by a random part of the
  /// distance to its neighbour. It also shakes surfaces. Two seeds must find one minimum.
  int seed = 0;
  /// Polylines of a slope that differs little, as of another time. Where there are any, the best of them and of the
  /// other starts are optimised, and none is shaken.
  std::vector<Surface> known{};
  int threads = 1;
  /// A signal ends the search, unless it came before it: who began then wants the result.
  bool ends_at_signal = true;
};

/// A surface that was tried, with the factors in the order of SearchOptions::methods (0: refused).
struct TriedCircle {
  Surface surface;
  std::vector<float> factors;
};

/// The critical surface of one method.
struct Critical {
  Method method = Method::spencer;
  Surface surface;
  Solution solution;
  CutSurface cut;  ///< with the forces
  bool circular = true;
  std::vector<std::string> warnings;  ///< m_α, tension, model's edge, limits of the search that were hit
  std::optional<double> yield_acceleration;
};

/// A critical surface that lies at a limit of the search.
struct LimitHit {
  Method method;
  std::string limit;  ///< "the entry of the critical circle lies at x = 3 m, …"
};

struct SearchResult {
  std::vector<Critical> circular;             ///< per method that found one
  std::vector<Critical> noncircular;          ///< per method (of those that suit polylines), when asked for
  std::vector<std::vector<Critical>> minima;  ///< per method: several separate local minima, best first
  std::vector<TriedCircle> trials;            ///< every trial circle of the search
  /// The smallest factor per centre of the grid, per method (grid search; else of the circles binned by their centres).
  struct Map {
    Point from{}, to{};
    int columns = 0, rows = 0;
    std::vector<float> factor;  ///< row by row; NaN: none
  };
  std::vector<Map> maps;
  std::vector<std::map<Refusal, long>> refused;  ///< per method
  long tried = 0;
  double smallest_depth = 0;  ///< of a mass that the search took [m]
  std::vector<LimitHit> limit_hits;
  std::vector<std::string> warnings;  ///< on methods that have no solution where others have their smallest factor
  double seconds = 0;
  /// Where it was searched, as used.
  std::optional<GridSearch> grid;
  std::optional<EntryExitSearch> entry_exit;

  // Compiled once, in search.cpp: the files that hold one would each compile them again.
  SearchResult();
  SearchResult(const SearchResult&);
  SearchResult(SearchResult&&) noexcept;
  SearchResult& operator=(const SearchResult&);
  SearchResult& operator=(SearchResult&&) noexcept;
  ~SearchResult();
};

/// Throws Error (wrong_input) when no admissible surface is found: the sentence counts the reasons.
SearchResult search(const Slope& slope, const SearchOptions& options);

/// The surface with its slices, forces, factor and warnings.
Critical make_critical(const Slope& slope, const SearchOptions& options, const Surface& surface, Method method);

/// Optimises the vertices of a polyline surface, or a circle (its ends and depth), from a start.
Critical optimise(const Slope& slope, const Surface& start, Method method, const SearchOptions& options);

}  // namespace talus::lem
