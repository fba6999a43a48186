// SPDX-License-Identifier: MIT
#pragma once
// The factor at which the least lacking cohesion is zero, on one mesh.

#include <functional>
#include <optional>
#include <string>

#include "bounds/program_of.hpp"

namespace talus::bounds {

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

}  // namespace talus::bounds
