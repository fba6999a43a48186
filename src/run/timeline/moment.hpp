// SPDX-License-Identifier: MIT
#pragma once
// The slope at one time of a timeline, and the slip surfaces that are found there.

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "lem/search/search.hpp"
#include "results/timeline.hpp"

namespace talus::run {

// A case that begins at a later time.

/// The case without its timeline, whose time 0 is just before `time` [s]: it begins with `water` (none: as [initial]
/// says), and its series of [[hydraulic]] and of transpiration go on from there. A series that jumps at `time` jumps
/// after the beginning.
input::Case begin_later(input::Case data, double time, std::shared_ptr<const input::KnownWater> water);

struct Moment {
  double time = 0;  ///< [s]
  std::unique_ptr<lem::Slope> slope;
  std::vector<lem::Critical> circular, noncircular, given;
  std::string error;  ///< why there is no surface
  /// Of the surfaces of other times that the checks refuse here: the least factor, and why it is refused.
  double refused_factor = std::numeric_limits<double>::infinity();
  lem::Refusal refusal = lem::Refusal::none;
  std::optional<results::Referee> referee;  ///< nothing: it was not asked at this time
};

/// What a search of the run has found at the time of `moment`.
void take_known(const results::SliceResult& found, const lem::SearchOptions& options, Moment& moment);

/// The surfaces of a time, and a time that has these.
results::SearchedMoment keep_moment(const Moment& moment);
void take_kept(const results::SearchedMoment& kept, const lem::SearchOptions& options, Moment& moment);

/// Search, or the surfaces of the case; polylines begin with those of `others`.
void search_moment(const input::Case& data, lem::SearchOptions options, const std::vector<Moment>& others,
                   Moment& moment);

/// Tries the surfaces of each time at all others, improves them where they are lower, and so on until none is, at most
/// four times. The same for any number of threads.
void share_surfaces(const lem::SearchOptions& options, int threads, std::vector<Moment>& moments);

/// The least factor of surfaces that govern at other times; nothing where all are refused.
std::optional<double> try_surfaces(const std::vector<results::TimedFactor>& known, const lem::SearchOptions& options,
                                   const lem::Slope& slope);

/// The surface that governs.
results::TimedFactor make_moment_result(const lem::SearchOptions& options, const Moment& moment);

}  // namespace talus::run
