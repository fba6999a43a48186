// SPDX-License-Identifier: MIT
#pragma once
// Limit analysis in a run: computed or read from an interrupted run, and stored in the folder.

#include <chrono>
#include <optional>
#include <string>

#include "bounds/find_bounds.hpp"
#include "results/bounds.hpp"
#include "results/run.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "run/common/run_folder.hpp"

namespace talus::run {

/// Converts bounds, meshes, fields and slip lines of the mechanism; adds warnings if a bound is missing, or the
/// interval is wider than the requested gap.
results::BoundsFile make_bounds_result(const bounds::BoundsResult& found, double asked_gap);

class BoundsRun {
 public:
  /// `data`: the case or its design values. `alone`: the case has no other method.
  BoundsRun(const input::Case& data, bool alone, const RunOptions& options, std::string input_hash);

  /// Prepares the first mesh; writes nothing. Throws Error (interrupted); if limit analysis is the only method, what
  /// make_bounds_problem() throws, otherwise the reason is part of the result.
  void prepare();
  /// Computes both bounds, starting from the factor of another method (or 1), and stores them. Throws Error
  /// (interrupted).
  void calculate(std::optional<double> start);
  void write_result(results::RunResult& run) const;
  /// See SliceRun.
  const results::WaterFields* water_fields() const { return water_.fields ? &*water_.fields : nullptr; }

 private:
  template <class Part>
  void attempt(Part part);
  void show(const std::string& what) const;
  results::BoundsFile search(const bounds::Problem& problem, const bounds::BoundsOptions& options) const;
  void search_other_direction(const bounds::BoundsOptions& options);

  const input::Case& data_;
  const RunOptions& options_;
  std::string hash_;
  bool alone_;
  std::optional<ProblemOfCase> made_;
  site::WaterResult water_;
  results::BoundsFile file_;
  bool is_known_ = false;  ///< of an interrupted run
  std::chrono::duration<double> spent_{0};
};

}  // namespace talus::run
