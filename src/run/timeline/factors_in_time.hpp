// SPDX-License-Identifier: MIT
#pragma once
// LEM searches at selected times of a timeline, and the factors at these times.

#include <optional>
#include <string>
#include <vector>

#include "results/timeline.hpp"
#include "run/common/run_folder.hpp"
#include "run/timeline/water_in_time.hpp"

namespace talus::run {

/// The searches are stored at once, so that an interrupted run resumes from them.
class FactorsInTime {
 public:
  /// `summary` receives the factors. All arguments must outlive this object.
  FactorsInTime(const WaterInTime& water, const RunOptions& options, std::string input_hash,
                results::Timeline& summary);

  /// Searches at the times that TimeChoice selects, or at those of the case. `first`: the result at time 0.
  void search_curve(const results::SliceResult& first);
  /// Searches at some times, exchanges the surfaces between all times, and updates the factors. Returns false if all of
  /// them were tried before.
  bool search_at(const std::vector<std::size_t>& numbers);
  /// Compares the least factor, and those between which the slope fails, with the interval of limit analysis. If limit
  /// analysis rejects a factor, another time may govern, which is compared next.
  void judge_governing_times();

  /// Indices of the tried times, and the moments in the order of time.
  const std::vector<std::size_t>& tried() const { return tried_; }
  std::vector<const Moment*> list_moments() const;
  std::optional<double> find_factor(std::size_t number) const;
  /// Removes the file that only a resumed run needs.
  void forget() const;

 private:
  bool search_more(std::vector<std::size_t> next);
  void show_moment(const Moment& moment, std::size_t done, std::size_t total) const;
  void share();
  void make_results();
  void take_kept_moments();
  void extend_guide(const std::vector<results::TimedFactor>& fresh);

  const WaterInTime& water_;
  const input::Case& data_ = water_.data();
  const std::vector<double>& times_ = water_.times();
  const RunOptions& options_;
  const std::string hash_;
  const lem::SearchOptions search_;  ///< for one time, with one thread: the times are searched in parallel
  results::Timeline& summary_;
  std::vector<Moment> moments_;
  std::vector<std::size_t> tried_;  ///< indices of the times of the moments
  results::TimelineFile kept_{hash_, {}};
  std::vector<std::optional<double>> guide_;  ///< least factor at every time of the surfaces that govern at some time
};

}  // namespace talus::run
