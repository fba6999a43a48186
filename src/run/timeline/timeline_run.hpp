// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety in time: one transient seepage solution, and LEM searches at many of its times
// (docs/theory/24-timeline.md).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"
#include "run/common/run_folder.hpp"
#include "run/lem/run_lem.hpp"

namespace talus::run {

/// A case that starts from the pore water of one time, and whose series continue from there.
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
  /// Throws Error (wrong_input) if the soil has no water storage.
  TimelineRun(const input::Case& data, const RunOptions& options, std::string input_hash);
  ~TimelineRun();

  /// `prepared`, `first`: the slope at time 0 and its LEM result. Throws what transient seepage throws, and Error
  /// (interrupted).
  void calculate(const PreparedSlope& prepared, const results::SliceResult& first);
  /// Returns the cases of the release to MPM by [timeline.release]: at the time itself, then at the earlier and the
  /// later one. Empty, with a note, if the factor does not fall below the target.
  std::vector<ReleaseCase> list_releases();
  /// Returns the cases of strength reduction by FEM by `element_times`.
  std::vector<ReductionCase> list_reductions() const;
  void add_reduction(results::TimedReduction reduction);
  void add_release(results::Release release);
  void write_result(results::RunResult& run) const;
  /// Removes the files that only a resumed run needs.
  void forget() const;
  /// Water fields at the times of the factors; nullptr if they are too large for a report.
  const results::WaterFields* water_fields() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace talus::run
