// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety in time: one transient seepage solution, and LEM searches at many of its times
// (docs/theory/24-timeline.md).

#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"
#include "run/common/run_folder.hpp"
#include "run/timeline/factors_in_time.hpp"
#include "run/timeline/water_in_time.hpp"

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

/// Sequence of the seepage, the searches and the release, and their results.
class TimelineRun {
 public:
  /// Throws Error (wrong_input) if the soil has no water storage.
  TimelineRun(const input::Case& data, const RunOptions& options, std::string input_hash);
  TimelineRun(const TimelineRun&) = delete;
  TimelineRun& operator=(const TimelineRun&) = delete;

  /// `prepared`, `first`: the slope at time 0 and its LEM result. Throws what transient seepage throws, and Error
  /// (interrupted).
  void calculate(const PreparedSlope& prepared, const results::SliceResult& first);
  /// Returns the cases of the release to MPM by [timeline.release]: at the time itself, then at the earlier and the
  /// later one. Empty, with a note, if the factor does not fall below the target.
  std::vector<ReleaseCase> list_releases();
  /// Returns the cases of strength reduction by FEM by `element_times`.
  std::vector<ReductionCase> list_reductions() const;
  void add_reduction(results::TimedReduction reduction) { summary_.elements.push_back(std::move(reduction)); }
  void add_release(results::Release release) { summary_.releases.push_back(std::move(release)); }
  void write_result(results::RunResult& run) const;
  /// Removes the files that only a resumed run needs.
  void forget() const { factors_.forget(); }
  /// Water fields at the times of the factors; nullptr if they are too large for a report.
  const results::WaterFields* water_fields() const { return water_.fields(); }

 private:
  void search(const results::SliceResult& first);
  void search_releases();
  void search_loss();
  void add_notes();
  void add_refusal_note(const std::vector<const Moment*>& moments);
  void add_pool_notes();
  void note(std::string sentence) { summary_.notes.push_back(std::move(sentence)); }
  void show(const std::string& what) const;

  std::optional<std::size_t> find_release() const;
  std::vector<std::size_t> find_beside(std::size_t at) const;
  ReleaseCase make_release(std::size_t number) const;

  const RunOptions& options_;
  WaterInTime water_;
  const input::Case& data_ = water_.data();
  const std::vector<double>& times_ = water_.times();
  results::Timeline summary_;
  FactorsInTime factors_;
};

}  // namespace talus::run
