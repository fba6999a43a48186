// SPDX-License-Identifier: MIT
#pragma once
// Limit analysis in a run: computed or read from an interrupted run, and stored in the folder.

#include <optional>
#include <string>

#include "bounds/find_bounds.hpp"
#include "results/bounds.hpp"
#include "results/run.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "run/common/method_run.hpp"

namespace talus::run {

/// Converts bounds, meshes, fields and slip lines of the mechanism; adds warnings if a bound is missing, or the
/// interval is wider than the requested gap.
results::BoundsFile make_bounds_result(const bounds::BoundsResult& found, double asked_gap);

class BoundsRun : public MethodRun<results::BoundsFile> {
 public:
  /// `site`: of the case or its design values. `alone`: the case has no other method.
  BoundsRun(const site::Site& site, bool alone, const RunOptions& options, std::string input_hash);

  /// Prepares the first mesh; writes nothing. Throws Error (interrupted); if limit analysis is the only method, what
  /// make_bounds_problem() throws, otherwise the reason is part of the result.
  void prepare();
  /// Computes both bounds, starting from the factor of another method (or 1), and stores them. Throws Error
  /// (interrupted).
  void calculate(std::optional<double> start);
  void write_result(results::RunResult& run) const;

 private:
  results::BoundsFile search(const ProblemOfCase& made, const bounds::BoundsOptions& options);
  /// Stores the bounds so far.
  void keep_present(const bounds::BoundsResult& found) const;
  void search_other_direction(const bounds::BoundsOptions& options);

  const site::Site site_;
  const input::Case& data_;
  std::optional<ProblemOfCase> made_;
  bool is_known_ = false;  ///< of an interrupted run
  PresentClock clock_;
};

}  // namespace talus::run
