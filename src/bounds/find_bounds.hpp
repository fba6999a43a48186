// SPDX-License-Identifier: MIT
#pragma once
// The interval of the factor of safety by limit analysis: both programs, on meshes that are refined where the gap is.

#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "bounds/check.hpp"
#include "bounds/program_of.hpp"

namespace talus::bounds {

// The root of the least lacking cohesion m(F) on one mesh (T21.2).

/// Result of one factor.
struct Trial {
  double factor = 0;
  double lack = 0;   ///< least m [units of stress]
  double doubt = 0;  ///< difference of the primal and the dual value of m [units of stress]
  double rate = 0;   ///< dm/dF
  ConicSolution solution;
};

/// Range of the factors that are searched.
struct FactorRange {
  double smallest = 0.05, largest = 20;
};

class FactorSearch {
 public:
  /// `solve` computes the trial of a factor. If its program is not solved, the search ends and why() gives the reason.
  using Solve = std::function<Trial(double)>;
  FactorSearch(const FactorRange& range, Solve solve) : range_(range), solve_(std::move(solve)) {}

  /// Searches the root by Newton's method between the stable and the failed factors, until the last trial is within
  /// `tolerance` (relative) of it. Returns false, with why(), if there is no root in the range or a program has no
  /// solution.
  bool approach(double start, double tolerance);
  /// Evaluates one factor.
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
  bool is_undecided_ = false;  ///< of the last trial
  std::string why_;
  int programs_ = 0, iterations_ = 0;
};

struct BoundsOptions {
  double gap = 0;          ///< width of the interval over its middle at which the refinement ends
  int most_triangles = 0;  ///< a mesh with as many triangles is the last one
  double start = 1;        ///< first factor
  /// Number of meshes whose programs reach the gap but whose fields prove a wider interval, after which the search
  /// stops.
  int most_unproven = std::numeric_limits<int>::max();
  int threads = 1;  ///< 2: both programs of a mesh in parallel
  FactorRange range;
};

/// Results on one mesh.
struct BoundsLevel {
  int triangles = 0;
  double lower = 0, upper = 0;  ///< proven
  int programs = 0, iterations = 0;
  double seconds = 0;  ///< since the start
};

struct BoundsResult {
  /// Largest factor proven by a stress field and smallest one proven by a mechanism, of all meshes; 0 and infinity if
  /// there is none.
  double lower = 0, upper = 0;
  std::string no_lower, no_upper;  ///< reason why there is none; empty where there is one
  std::string stopped;             ///< reason why no finer mesh followed, other than gap or size; else empty
  Problem problem;                 ///< the finest mesh
  /// The fields that prove the bounds, with their meshes.
  Problem stress_problem, velocity_problem;
  StressField stress;
  VelocityField velocity;
  StaticCheck static_check;
  KinematicCheck kinematic_check;
  std::vector<BoundsLevel> levels;
};

/// Receives the result so far after every mesh; its level is the last one.
using BoundsReport = std::function<void(const BoundsResult&)>;

BoundsResult find_bounds(const Problem& problem, const BoundsOptions& options, const BoundsReport& report = {});

/// Strengths and pore pressures on the safe side of each bound, where those of a section are not linear in a triangle.
struct SafeProblems {
  Problem lower;
  std::optional<Problem> upper;  ///< the same mesh, loads and supports; none: as `lower`
  /// Evaluates the strengths and the pore pressures of a refined problem; empty: they are linear in the triangles of
  /// the first mesh.
  std::function<void(Problem&, Bound)> evaluate;
};

BoundsResult find_bounds(const SafeProblems& problems, const BoundsOptions& options, const BoundsReport& report = {});

}  // namespace talus::bounds
