// SPDX-License-Identifier: MIT
#pragma once
// LEM in a run: computed or read from an interrupted run, and stored in the folder.

#include <optional>
#include <string>
#include <vector>

#include "lem/search/search.hpp"
#include "results/run.hpp"
#include "results/slices.hpp"
#include "run/common/method_run.hpp"
#include "run/lem/run_lem.hpp"

namespace talus::run {

/// Vertices of the bases of the slices, also for a circle; for a rejected surface its own vertices.
std::vector<lem::Point> list_points(const lem::CutSurface& cut);

/// Method, factor and shape of a surface.
results::SlipSurface make_surface_result(const lem::Critical& critical);
/// The same with checks, slices and warnings.
results::CriticalSurface make_critical_result(const lem::Slope& slope, const lem::Critical& critical);

/// Numbers of tried and rejected surfaces, reasons and places, and the limits at which critical surfaces lie.
results::SliceSearch make_search_result(const lem::SearchOptions& options, const lem::SearchResult& result);

/// All circles with the factor by each method, and the least factor for each centre of a grid.
results::SliceTrials make_trials_result(const lem::SearchOptions& options, const lem::SearchResult& result);

class SliceRun : public MethodRun<results::SliceFile> {
 public:
  /// Prepares the slope; throws what prepare_slope() throws. `site`: of the case or its design values. `alone`: the
  /// case has no other method.
  SliceRun(const site::Site& site, bool alone, const RunOptions& options, std::string input_hash);

  /// Throws Error (interrupted), and Error (wrong_input) if LEM is the only method and no surface is admissible; with
  /// other methods the reason is part of the result.
  void calculate();
  /// Returns true if the result is still to be compared with limit analysis.
  bool needs_referee() const { return is_done_ && data_.lem.referee && !file_.summary.error && !file_.summary.referee; }
  /// Marks the factors that limit analysis proves impossible.
  void take_referee(results::Referee referee);
  /// Writes lem.json, unless it is that of an earlier run.
  void keep();
  void write_result(results::RunResult& run) const;

  /// Result that was computed or read from the folder.
  const results::SliceResult& result() const { return file_.summary; }
  const lem::Slope* slope() const { return prepared_.slope.get(); }
  const PreparedSlope& prepared() const { return prepared_; }

 private:
  const site::Site site_;
  const input::Case& data_;
  PreparedSlope prepared_;
  bool is_kept_ = false, is_done_ = false;
};

}  // namespace talus::run
