// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety in time: one transient seepage solution, and searches of slices at many of its times
// (docs/theory/24-timeline.md).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"
#include "run/lem/run_lem.hpp"
#include "run/run_folder.hpp"

namespace talus::run {

/// A case that begins with the pore water of one time, and whose series go on from there.
struct ReleaseCase {
  results::Release summary;  ///< time, factor and folder
  input::Case data;
};

struct ReductionCase {
  results::TimedReduction summary;  ///< time and folder
  input::Case data;
};

class TimelineRun {
 public:
  /// Throws Error (wrong_input) where the soil stores no water.
  TimelineRun(const input::Case& data, const RunOptions& options, std::string input_hash);
  ~TimelineRun();

  /// `prepared`, `first`: the slope at time 0, and what slices found there. Throws what seepage in time throws, and
  /// Error (interrupted).
  void calculate(const PreparedSlope& prepared, const results::SliceResult& first);
  /// What material points take over, as [timeline.release] asks: the time itself, then the earlier and the later one.
  /// Empty where the factor does not fall below the target; a note says so.
  std::vector<ReleaseCase> list_releases();
  /// Where finite elements reduce the strength, as `element_times` asks.
  std::vector<ReductionCase> list_reductions() const;
  void add_reduction(results::TimedReduction reduction);
  void add_release(results::Release release);
  void write_result(results::RunResult& run) const;
  /// Removes what an interrupted run would go on from.
  void forget() const;
  /// Fields of the water at the times of the factors; nullptr where they are more than a report draws.
  const results::WaterFields* water_fields() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace talus::run
