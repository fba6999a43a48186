// SPDX-License-Identifier: MIT
#pragma once
// The slope at one time of a timeline, and its critical slip surfaces.

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "lem/search/search.hpp"
#include "results/timeline.hpp"

namespace talus::run {

/// Returns the case without its timeline, with time 0 just before `time` [s]: it starts from `water` (null: that of
/// [initial]), and its series of [[hydraulic]] and of transpiration continue from there. A series that jumps at `time`
/// jumps after the start. Soil without pore water of its own keeps the pressure of a water table or a grid.
input::Case begin_later(input::Case data, double time, std::shared_ptr<const input::KnownWater> water);

struct Moment {
  double time = 0;  ///< [s]
  std::unique_ptr<lem::Slope> slope;
  std::vector<lem::Critical> circular, noncircular, given;
  std::string error;  ///< reason why there is no surface
  /// Least factor of the surfaces of other times that are rejected at this time, and the reason.
  double refused_factor = std::numeric_limits<double>::infinity();
  lem::Refusal refusal = lem::Refusal::none;
  std::optional<results::Referee> referee;  ///< nullopt: limit analysis was not used at this time
};

/// Copies the surfaces of the search of the run at the time of `moment`.
void take_known(const results::SliceResult& found, const lem::SearchOptions& options, Moment& moment);

/// Converts the surfaces of a time for storage, and back.
results::SearchedMoment keep_moment(const Moment& moment);
void take_kept(const results::SearchedMoment& kept, const lem::SearchOptions& options, Moment& moment);

/// Searches, or evaluates the surfaces of the case; polylines start from those of `others`.
void search_moment(const input::Case& data, lem::SearchOptions options, const std::vector<Moment>& others,
                   Moment& moment);

/// Evaluates the surfaces of each time at all others, optimises them if their factor is lower, and repeats until none
/// is, at most four times. The result does not depend on the number of threads.
void share_surfaces(const lem::SearchOptions& options, int threads, std::vector<Moment>& moments);

/// Returns the least factor of surfaces that govern at other times; nullopt if all are rejected.
std::optional<double> try_surfaces(const std::vector<results::TimedFactor>& known, const lem::SearchOptions& options,
                                   const lem::Slope& slope);

/// Makes the result of the governing surface.
results::TimedFactor make_moment_result(const lem::SearchOptions& options, const Moment& moment);

}  // namespace talus::run
