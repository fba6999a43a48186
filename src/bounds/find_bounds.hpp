// SPDX-License-Identifier: MIT
#pragma once
// The interval that holds the factor of safety: both programs, on meshes that become finer where the gap is.

#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "bounds/check.hpp"
#include "bounds/program_of.hpp"

namespace talus::bounds {

// The factor at which the least lacking cohesion is zero, on one mesh.

/// A factor that was tried.
struct Trial {
  double factor = 0;
  double lack = 0;   ///< least m [units of stress]
  double doubt = 0;  ///< what the solver leaves between the bounds of the least m [units of stress]
  double rate = 0;   ///< its derivative by the factor
  ConicSolution solution;
};

/// Range in which factors are looked for.
struct FactorRange {
  double smallest = 0.05, largest = 20;
};

class FactorSearch {
 public:
  /// `solve`: ends with end == solved, or the search ends with its sentence.
  using Solve = std::function<Trial(double)>;
  FactorSearch(const FactorRange& range, Solve solve) : range_(range), solve_(std::move(solve)) {}

  /// Newton's method between the factors that stood and those that fell, until the last trial is no further from the
  /// root than `tolerance` of it. False with why() when there is no root in the range, or a program has no solution.
  bool approach(double start, double tolerance);
  /// One trial.
  bool try_factor(double factor);

  bool has_root() const { return root_.has_value(); }
  double root() const { return *root_; }
  const Trial& last() const { return *last_; }
  const std::string& why() const { return why_; }
  int programs() const { return programs_; }
  int iterations() const { return iterations_; }

 private:
  FactorRange range_;
  Solve solve_;
  std::optional<Trial> last_;
  std::optional<double> stood_, fell_, root_;
  bool is_undecided_ = false;  ///< the last trial
  std::string why_;
  int programs_ = 0, iterations_ = 0;
};

struct BoundsOptions {
  double gap = 0;          ///< of the interval over its middle, at which the meshes end
  int most_triangles = 0;  ///< a mesh with as many is the last
  double start = 1;        ///< a factor to begin with
  /// Meshes on which the programs come within the gap but their fields prove a wider interval, before the search stops.
  int most_unproven = std::numeric_limits<int>::max();
  int threads = 1;  ///< 2: both programs of a mesh at once
  FactorRange range;
};

/// One mesh.
struct BoundsLevel {
  int triangles = 0;
  double lower = 0, upper = 0;  ///< proven
  int programs = 0, iterations = 0;
  double seconds = 0;  ///< since the beginning
};

struct BoundsResult {
  /// Largest factor of a field that holds, smallest factor of one that moves: of all meshes. 0 and infinite where none
  /// was found.
  double lower = 0, upper = 0;
  std::string no_lower, no_upper;  ///< why there is none; empty where there is one
  std::string stopped;             ///< why no finer mesh followed, but the gap or the size; empty else
  Problem problem;                 ///< the finest mesh
  /// The fields that prove, with the meshes they are on.
  Problem stress_problem, velocity_problem;
  StressField stress;
  VelocityField velocity;
  StaticCheck static_check;
  KinematicCheck kinematic_check;
  std::vector<BoundsLevel> levels;
};

BoundsResult find_bounds(const Problem& problem, const BoundsOptions& options,
                         const std::function<void(const BoundsLevel&)>& report = {});

}  // namespace talus::bounds
