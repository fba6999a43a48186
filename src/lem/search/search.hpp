// SPDX-License-Identifier: MIT
#pragma once
// The search for the critical slip surface: its options, its result, and the evaluation of one surface.

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

// Evaluator computes the factors of many surfaces by one method and reuses its memory; each thread has its own.

/// Throws Error (interrupted) after a signal, as a search may take minutes and has no partial result.
inline void throw_if_search_is_interrupted(bool ends_at_signal) {
  if (ends_at_signal && is_interrupted())
    throw Error(ExitCode::interrupted, "interrupted while slip surfaces were searched");
}

struct OptimisedSurface {
  Surface surface;
  double factor = 0;  ///< Evaluator::refused if no surface was found
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

  /// Returns F, or `refused` for an invalid surface or one without a factor. A polyline below the wedge mechanism of
  /// its base has a value above F that grows with the distance (T18.12), so that a minimiser returns to admissible
  /// surfaces. The mechanism is computed only where F is below the smallest factor that passed so far. Throws Error
  /// (interrupted) after a signal.
  double operator()(const Surface& surface);
  /// Returns true if the factor of a surface passes all checks, the wedge check included.
  bool passes_all_checks(const Surface& surface);
  /// The surface with the smallest factor so far that passed the wedge check.
  const OptimisedSurface& passing() const { return passing_; }
  /// Increases the penalty. With a steep penalty a minimiser leaves inadmissible surfaces at once; with a gentle one it
  /// follows the border of the admissible ones.
  void steepen() { penalty_ = 4; }
  int count() const { return count_; }
  const Slope& slope() const { return *slope_; }
  Method method() const { return method_; }

  static constexpr double refused = 1e6;  ///< above any factor, and finite for the minimisers

 private:
  const Slope* slope_;
  Method method_;
  Checks checks_, strict_;  ///< without and with the wedge check
  /// Slightly below the limit of the check, so that the result of a minimiser passes it.
  double most_below_wedges_ = std::numeric_limits<double>::infinity();
  int slices_;
  bool ends_at_signal_;
  CutSurface cut_;
  WedgeMechanism wedges_;
  int count_ = 0;
  double penalty_ = 1.5;
  OptimisedSurface passing_{{}, refused, 0};
};

/// Trial circles from a grid of centres, with radii that follow from the elevation of the deepest point.
struct GridSearch {
  Point from{}, to{};           ///< corners of the grid of centres [m]; chosen from the ground if they are equal
  int columns = 20, rows = 20;  ///< number of centres
  int radii = 11;
  std::optional<double> lowest, highest;  ///< range of elevations of the deepest points [m]
};

/// Trial circles through an entry and an exit on the ground, with several depths each. If both ranges are empty (equal
/// ends), the circles pass through any two of exits + entries points of the whole ground and slide to the lower one.
struct EntryExitSearch {
  std::array<double, 2> exit{};   ///< range of x at the toe [m]
  std::array<double, 2> entry{};  ///< range of x at the crest [m]
  int exits = 25, entries = 25, depths = 15;

  bool is_whole_ground() const { return exit[0] == exit[1] && entry[0] == entry[1]; }
};

/// Trial polylines with a vertex in each window, or along a path, between two straight ends.
struct BlockSearch {
  std::vector<Window> windows;
  Path path;                                         ///< without points: the windows
  std::array<double, 2> active{}, passive{};         ///< inclinations of the upper and the lower end [rad]
  int angles = 5;                                    ///< inclinations in each range
  int surfaces = 5000;                               ///< number of trial polylines, about
  std::optional<std::array<double, 2>> exit, entry;  ///< ranges of x of the ends [m]
};

enum class SearchKind { entry_exit, grid, block };

struct SearchOptions {
  SearchKind kind = SearchKind::entry_exit;
  std::optional<GridSearch> grid;             ///< chosen from the ground if not given
  std::optional<EntryExitSearch> entry_exit;  ///< if not given: the whole ground, both directions of sliding
  std::optional<BlockSearch> block;           ///< of SearchKind::block
  std::optional<TangentLines> tangent;        ///< restricts the circles; no polyline is searched then
  int slices = 50;
  std::vector<Method> methods{Method::bishop, Method::spencer};
  Checks checks;
  bool composite = false;        ///< circles below the bottom of the soil continue along it
  bool optimise_circle = true;   ///< local optimisation of the best local minima
  bool optimise_surface = true;  ///< optimisation of a non-circular surface from the critical circle
  int vertices = 12;             ///< number of vertices of the non-circular surface
  int kept_minima = 5;           ///< local minima in the result
  /// False: the largest depth of a mass must be at least 2 % of the relief of the ground, or 0.5 m if that is less. At
  /// the edge of a load and in soil without cohesion, ever smaller masses have ever smaller factors.
  bool finds_skins = false;
  /// Seed of the perturbation of trial surfaces. 0: entries, exits and blocks stand at their regular places; otherwise
  /// each is moved by a random fraction of the distance to its neighbour, and the perturbations of polylines change
  /// too. The minimum should not depend on the seed.
  int seed = 0;
  /// Polylines of a similar slope, such as that of another time. If there are any, only the best of them and of the
  /// other starts are optimised, without perturbations.
  std::vector<Surface> known{};
  int threads = 1;
  /// A signal ends the search, but not one that came before the search began.
  bool ends_at_signal = true;
};

/// A trial circle, or polyline of a search for blocks, with its factors in the order of SearchOptions::methods (0:
/// rejected).
struct TriedCircle {
  Surface surface;
  std::vector<float> factors;
};

/// The critical surface of one method.
struct Critical {
  Method method = Method::spencer;
  Surface surface;
  Solution solution;
  CutSurface cut;  ///< its slices with the forces
  bool circular = true;
  std::vector<std::string> warnings;         ///< on m_α, tension, the edge of the model, and limits of the search
  std::optional<double> yield_acceleration;  ///< k_y, over g; the search does not compute it
};

/// A critical surface that lies at a limit of the search.
struct LimitHit {
  Method method;
  std::string limit;  ///< "the entry of the critical circle lies at x = 3 m, …"
};

struct SearchResult {
  std::vector<Critical> circular;             ///< one per method that has a solution
  std::vector<Critical> noncircular;          ///< one per method that applies to polylines, if requested
  std::vector<std::vector<Critical>> minima;  ///< distinct local minima per method, best first
  std::vector<TriedCircle> trials;            ///< all trial circles
  /// Smallest factor per centre, per method: of the grid's centres, or of the circles binned by their centres.
  struct Map {
    Point from{}, to{};
    int columns = 0, rows = 0;
    std::vector<float> factor;  ///< row by row; NaN where there is no factor
  };
  std::vector<Map> maps;
  std::vector<std::map<Refusal, long>> refused;  ///< number per reason, per method
  long tried = 0;
  double smallest_depth = 0;  ///< limit of the depth that the search applied [m]
  std::vector<LimitHit> limit_hits;
  std::vector<std::string> warnings;  ///< on methods without a solution where another has its smallest factor
  double seconds = 0;
  /// Ranges of the search as applied.
  std::optional<GridSearch> grid;
  std::optional<EntryExitSearch> entry_exit;
  std::optional<BlockSearch> block;
};

/// Throws Error (wrong_input), with the numbers of rejected surfaces by reason, when no admissible surface is found.
SearchResult search(const Slope& slope, const SearchOptions& options);

/// Returns the surface with its slices, forces, factor and warnings.
Critical make_critical(const Slope& slope, const SearchOptions& options, const Surface& surface, Method method);

/// Optimises the vertices of a polyline, or the ends and the depth of a circle, from a start. A polyline of a search
/// for blocks stays as it is.
Critical optimise(const Slope& slope, const Surface& start, Method method, const SearchOptions& options);

}  // namespace talus::lem
