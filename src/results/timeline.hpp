// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety in time: when it was found, where it is least, and when it falls below the target.

#include <optional>
#include <string>
#include <vector>

#include "results/elements.hpp"
#include "results/runout.hpp"
#include "results/slices.hpp"
#include "results/water.hpp"

namespace talus::results {

/// The slip surface that governs at one time.
struct TimedFactor {
  double time = 0;               ///< [s]
  std::optional<double> factor;  ///< nothing: no surface was admissible
  SlipSurface surface;
  std::string source;              ///< "critical polyline"
  std::string refusal;             ///< why a search would refuse it; empty: it would not
  std::optional<Referee> referee;  ///< at governing times: the interval that the factor is held against
};
template <class V, As<TimedFactor> R>
void describe(V& v, R& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("surface", r.surface, {"", "the slip surface that governs"});
  v.key("source", r.source, {"", "what the surface is"});
  v.key("refusal", r.refusal, {"", "why a search would refuse it"});
  v.maybe("referee", r.referee, {"", "limit analysis at this time, where the time governs"});
}

/// By how much the factors of two searches of one slope may differ, over the factor: twenty random starts scatter by as
/// much (docs/verification_data/search.md).
inline constexpr double search_scatter = 0.003;

/// Between two times the factor falls below the target; both were tried.
struct FailureTime {
  double from = 0, to = 0;                ///< [s]
  double factor_from = 0, factor_to = 0;  ///< [-]
  double earliest = 0;                    ///< the last time before at which it is higher by more than searches scatter
  std::optional<double> latest;           ///< the first time at which it is lower by as much; nothing: it never is
};
template <class V, As<FailureTime> R>
void describe(V& v, R& r) {
  v.key("from", r.from, {"s", "the last time at or above the target"});
  v.key("to", r.to, {"s", "the first time below it"});
  v.key("factor_from", r.factor_from, {"", "factor of safety at the first of them"});
  v.key("factor_to", r.factor_to, {"", "factor of safety at the second"});
  v.key("earliest", r.earliest,
        {"s", "last time before at which it is above the target by more than searches scatter"});
  v.key("latest", r.latest, {"s", "first time at which it is below the target by as much"});
}

/// Material points that took over at one time.
struct Release {
  double time = 0;               ///< [s]
  std::optional<double> factor;  ///< of the slices at that time
  std::string folder;            ///< of its results, inside that of the run; empty: the run itself
  bool rests = false;            ///< the soil came to rest before it was let go
  /// Strength factor of the equilibrium of finite elements whose stress the points began with; nothing: of none.
  std::optional<double> start_factor;
  std::optional<std::string> error;
  double largest_displacement = 0, moved_volume = 0, front_advance = 0, toe_distance = 0;  ///< as of Runout
  std::optional<double> front_uncertainty;  ///< that the mesh leaves in the advance of the front [m]; nothing: unknown
  std::optional<BoxLimit> limits;           ///< as of Runout
};
template <class V, As<Release> R>
void describe(V& v, R& r) {
  v.key("time", r.time, {"s", "when material points took over"});
  v.key("factor", r.factor, {"", "factor of safety at that time, by slices"});
  v.key("folder", r.folder, {"", "folder of its results; empty: the run itself"});
  v.key("rests", r.rests, {"", "whether the soil came to rest before it was let go"});
  v.key("start_factor", r.start_factor,
        {"", "what finite elements divided the strength by for the equilibrium that the points began with"});
  v.key("error", r.error, {"", "why it did not end"});
  v.key("largest_displacement", r.largest_displacement, {"m", "largest displacement"});
  v.key("moved_volume", r.moved_volume, {"m3", "moved volume"});
  v.key("front_advance", r.front_advance, {"m", "advance of the front"});
  v.key("toe_distance", r.toe_distance, {"m", "runout beyond the toe"});
  v.maybe("front_uncertainty", r.front_uncertainty,
          {"m", "what the mesh leaves open in the advance of the front, from a coarser mesh"});
  v.maybe("limits", r.limits, {"", "what the ends of the box limit"});
}

/// Finite elements at one time.
struct TimedReduction {
  double time = 0;               ///< [s]
  std::string folder;            ///< of its results, inside that of the run
  std::vector<ElementRun> runs;  ///< by flow rule
  std::optional<std::string> error;
};
template <class V, As<TimedReduction> R>
void describe(V& v, R& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("folder", r.folder, {"", "folder of its results"});
  v.key("runs", r.runs, {"", "strength reductions by flow rule"});
  v.key("error", r.error, {"", "why there is no answer"});
}

/// Between two times finite elements with the strength as given lose their equilibrium; both were tried.
struct EquilibriumLoss {
  std::optional<double> from;  ///< [s]; nothing: there was none at time 0 either
  std::optional<double> to;    ///< [s]; nothing: it was never lost
  int trials = 0;              ///< equilibria that were looked for
};
template <class V, As<EquilibriumLoss> R>
void describe(V& v, R& r) {
  v.key("from", r.from, {"s", "the last time with equilibrium"});
  v.key("to", r.to, {"s", "the first time without"});
  v.key("trials", r.trials, {"", "equilibria that were looked for"});
}

/// "timeline" of summary.json.
struct Timeline {
  double duration = 0;               ///< [s]
  std::optional<std::string> start;  ///< the date of time 0, "2023-03-01"
  double target = 1;
  std::vector<TimedFactor> factors;  ///< in time
  std::optional<double> least;       ///< of the factors
  std::optional<double> least_time;  ///< [s]
  bool fails_from_start = false;     ///< the factor at time 0 is below the target
  std::optional<FailureTime> failure;
  bool chosen = false;  ///< times were chosen, not given
  std::optional<double>
      distance;  ///< largest estimate of what a straight line between two times is off, over the factor
  std::vector<WaterState> states;              ///< where the water stood at the times of the factors
  std::vector<TimedReduction> elements;        ///< in time
  std::optional<EquilibriumLoss> equilibrium;  ///< where it is the criterion of the release
  bool pool_loading = false;                   ///< pools load saturated soil
  std::vector<Release> releases;               ///< the first is that of the run
  std::vector<std::string> notes;
  Season weather;
  double step_error = 0;  ///< the largest of a step of the seepage, by its prediction [m of water]
  double seepage_seconds = 0, search_seconds = 0;
};
template <class V, As<Timeline> R>
void describe(V& v, R& r) {
  v.key("duration", r.duration, {"s", "length of the timeline"});
  v.key("start", r.start, {"", "date of time 0"});
  v.key("target", r.target, {"", "a factor below it is failure"});
  v.key("factors", r.factors, {"", "factor of safety in time"});
  v.key("least", r.least, {"", "least factor of safety in time"});
  v.key("least_time", r.least_time, {"s", "when the factor is least"});
  v.key("fails_from_start", r.fails_from_start, {"", "whether the factor is below the target at time 0"});
  v.key("failure", r.failure, {"", "when the factor falls below the target"});
  v.key("chosen", r.chosen, {"", "whether the times were chosen"});
  v.key("distance", r.distance, {"", "what straight lines between the times are off at most, over the factor"});
  v.key("states", r.states, {"", "where the water stood at the times of the factors"});
  v.key("elements", r.elements, {"", "factors of safety of finite elements in time"});
  v.key("equilibrium", r.equilibrium, {"", "when finite elements lose their equilibrium"});
  v.key("pool_loading", r.pool_loading, {"", "whether the weight of pools compresses saturated soil"});
  v.key("releases", r.releases, {"", "material points that took over, the run itself first"});
  v.key("notes", r.notes, {"", "what must be known of it"});
  v.key("weather", r.weather, {"", "water that came, went and is stored"});
  v.key("step_error", r.step_error, {"m", "the largest error of a step of the seepage, by its prediction"});
  v.key("seepage_seconds", r.seepage_seconds, {"s", "seconds of the seepage"});
  v.key("search_seconds", r.search_seconds, {"s", "seconds of the searches"});
}

/// The surfaces that were found at one time, with their methods.
struct SearchedMoment {
  double time = 0;  ///< [s]
  std::vector<SlipSurface> circular, noncircular, given;
  std::string error;  ///< why there is none
};
template <class V, As<SearchedMoment> R>
void describe(V& v, R& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("circular", r.circular, {"", "critical circles"});
  v.key("noncircular", r.noncircular, {"", "critical polylines"});
  v.key("given", r.given, {"", "surfaces that the case gives"});
  v.key("error", r.error, {"", "why there is none"});
}

/// timeline.json: what an interrupted run has found.
struct TimelineFile {
  std::string input_hash;
  std::vector<SearchedMoment> moments;
};
template <class V, As<TimelineFile> R>
void describe(V& v, R& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("moments", r.moments, {"", "times that are searched"});
}

/// Finite elements at the time at which their factor is least, by the first flow rule; nullptr: they have none in time.
const TimedReduction* find_least_reduction(const Timeline& timeline);

/// Sets the least factor and the time of failure from the factors in time.
void find_failure(Timeline& timeline);

/// "2.5 days", with " (2023-03-03 12:00)" where the date of time 0 is known.
std::string format_moment(const Timeline& timeline, double time);

/// "The factor of safety falls below 1 between 3.38 and 3.94 h (1.000 and 0.999); it is least at 72 h, 0.941."
std::string format_failure(const Timeline& timeline);

/// What moved after the releases, and how much of it hangs on their time; empty where there are none.
std::string format_releases(const Timeline& timeline);

}  // namespace talus::results
