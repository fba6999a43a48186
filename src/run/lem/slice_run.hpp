// SPDX-License-Identifier: MIT
#pragma once
// Slices in a run: calculated or taken from an interrupted run, and kept in the folder.

#include <optional>
#include <string>
#include <vector>

#include "lem/search/search.hpp"
#include "results/run.hpp"
#include "results/slices.hpp"
#include "run/lem/run_lem.hpp"
#include "run/run_folder.hpp"

namespace talus::run {

// The results of slip surfaces and of the search for them.

/// The vertices of the bases, which a circle has too; of a surface that was refused its own.
std::vector<lem::Point> list_points(const lem::CutSurface& cut);

/// Method, factor and shape.
results::SlipSurface make_surface_result(const lem::Critical& critical);
/// The same with checks, slices and warnings.
results::CriticalSurface make_critical_result(const lem::Slope& slope, const lem::Critical& critical);

/// How many surfaces were tried and refused, why, where, and at which limits critical surfaces lie.
results::SliceSearch make_search_result(const lem::SearchOptions& options, const lem::SearchResult& result);

/// Every circle with the factors by each method, and the least factor over each centre of a grid.
results::SliceTrials make_trials_result(const lem::SearchOptions& options, const lem::SearchResult& result);

class SliceRun {
 public:
  /// Prepares the slope; throws what prepare_slope() throws. `data`: what is calculated. `alone`: the case has no
  /// other method.
  SliceRun(const input::Case& data, bool alone, const RunOptions& options, std::string input_hash);

  /// Throws Error (interrupted), and Error (wrong_input) where slices are alone and no surface is admissible; beside
  /// others the reason stands in the result.
  void calculate();
  /// Whether limit analysis has still to judge what was found.
  bool needs_referee() const {
    return is_done_ && data_.lem.referee && !outcome_.result.error && !outcome_.result.referee;
  }
  /// Marks the factors that it proves impossible.
  void take_referee(results::Referee referee);
  /// lem.json; nothing where it is that of an earlier run.
  void keep() const;
  void write_result(results::RunResult& run) const;

  /// Fields of the water that pore pressures are from; nullptr in dry ground.
  const results::WaterFields* water_fields() const {
    return prepared_.water.fields ? &*prepared_.water.fields : nullptr;
  }
  /// What it calculated or found in the folder.
  const results::SliceResult& result() const { return outcome_.result; }
  const lem::Slope* slope() const { return prepared_.slope.get(); }
  const PreparedSlope& prepared() const { return prepared_; }

 private:
  const input::Case& data_;
  const RunOptions& options_;
  std::string hash_;
  bool alone_, is_kept_ = false;
  PreparedSlope prepared_;
  SliceOutcome outcome_;
  bool is_done_ = false;
};

}  // namespace talus::run
