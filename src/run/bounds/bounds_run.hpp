// SPDX-License-Identifier: MIT
#pragma once
// Proven bounds in a run: calculated or taken from an interrupted run, and kept in the folder.

#include <chrono>
#include <optional>
#include <string>

#include "bounds/find_bounds.hpp"
#include "results/bounds.hpp"
#include "results/run.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "run/run_folder.hpp"

namespace talus::run {

// The results of proven bounds.

/// Bounds, meshes, fields and the lines of the mechanism; warnings where a bound is missing, or the interval is wider
/// than the gap that was asked for.
results::BoundsFile make_bounds_result(const bounds::BoundsResult& found, double asked_gap);

class BoundsRun {
 public:
  /// `data`: what is calculated. `alone`: the case has no other method.
  BoundsRun(const input::Case& data, bool alone, const RunOptions& options, std::string input_hash);

  /// The first mesh; nothing is written. Throws Error (interrupted); where bounds answer alone, what
  /// make_bounds_problem() throws, else the reason stands in the result.
  void prepare();
  /// Both bounds from a factor that another method found (or 1), kept in the folder. Throws Error (interrupted).
  void calculate(std::optional<double> start);
  void write_result(results::RunResult& run) const;
  /// As of SliceRun.
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
  ground::WaterResult water_;
  results::BoundsFile file_;
  bool is_known_ = false;  ///< of an interrupted run
  std::chrono::duration<double> spent_{0};
};

}  // namespace talus::run
