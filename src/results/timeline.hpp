// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety over time: factors, smallest factor, time of failure, and the MPM runs released from the
// timeline.

#include <optional>
#include <string>
#include <vector>

#include "base/shown_units.hpp"
#include "results/elements.hpp"
#include "results/runout.hpp"
#include "results/slices.hpp"
#include "results/water.hpp"

namespace talus::results {

/// Governing slip surface at one time.
struct TimedFactor {
  double time = 0;               ///< [s]
  std::optional<double> factor;  ///< nullopt if no surface was admissible
  SlipSurface surface;
  std::string source;              ///< such as "critical polyline"
  std::string refusal;             ///< reason for which a search would reject the surface; empty if admissible
  std::optional<Referee> referee;  ///< bounds by limit analysis; computed for the governing times only
};
void describe(auto& v, As<TimedFactor> auto& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("factor", r.factor, {"", "factor of safety"});
  v.key("surface", r.surface, {"", "the slip surface that governs"});
  v.key("source", r.source, {"", "what the surface is"});
  v.key("refusal", r.refusal, {"", "why a search would refuse it"});
  v.maybe("referee", r.referee, {"", "limit analysis at this time, where the time governs"});
}

/// Relative scatter of the factor between searches of the same slope, from twenty random starts
/// (docs/verification_data/search.md).
inline constexpr double search_scatter = 0.003;

/// Interval of time in which the factor falls below the target; searches were made at both ends.
struct FailureTime {
  double from = 0, to = 0;                ///< [s]
  double factor_from = 0, factor_to = 0;  ///< [-]
  double earliest = 0;                    ///< last time with a factor above target (1 + search_scatter) [s]
  std::optional<double> latest;           ///< first time with a factor below target (1 - search_scatter) [s]
};
void describe(auto& v, As<FailureTime> auto& r) {
  v.key("from", r.from, {"s", "the last time at or above the target"});
  v.key("to", r.to, {"s", "the first time below it"});
  v.key("factor_from", r.factor_from, {"", "factor of safety at the first of them"});
  v.key("factor_to", r.factor_to, {"", "factor of safety at the second"});
  v.key("earliest", r.earliest,
        {"s", "last time before at which it is above the target by more than searches scatter"});
  v.key("latest", r.latest, {"s", "first time at which it is below the target by as much"});
}

/// An MPM run that starts from one time of the timeline.
struct Release {
  double time = 0;               ///< [s]
  std::optional<double> factor;  ///< of LEM at that time
  std::string folder;            ///< folder of its results within that of the run; empty for the run itself
  bool rests = false;            ///< the soil was brought to rest before the release
  /// Strength reduction factor of the FEM equilibrium that gives the initial stress; nullopt if it is not from FEM.
  std::optional<double> start_factor;
  std::optional<std::string> error;
  double largest_displacement = 0, moved_volume = 0, front_advance = 0, toe_distance = 0;  ///< as in Runout
  std::optional<double> front_uncertainty;  ///< discretisation error of the front advance [m]; nullopt if unknown
  std::optional<BoxLimit> limits;           ///< as in Runout
};
void describe(auto& v, As<Release> auto& r) {
  v.key("time", r.time, {"s", "start of MPM"});
  v.key("factor", r.factor, {"", "factor of safety at that time, by LEM"});
  v.key("folder", r.folder, {"", "folder of its results; empty: the run itself"});
  v.key("rests", r.rests, {"", "whether the soil came to rest before it was let go"});
  v.key("start_factor", r.start_factor,
        {"", "strength reduction factor of the FEM equilibrium that gave the initial stress"});
  v.key("error", r.error, {"", "why it did not end"});
  v.key("largest_displacement", r.largest_displacement, {"m", "largest displacement"});
  v.key("moved_volume", r.moved_volume, {"m3", "moved volume"});
  v.key("front_advance", r.front_advance, {"m", "advance of the front"});
  v.key("toe_distance", r.toe_distance, {"m", "runout beyond the toe"});
  v.maybe("front_uncertainty", r.front_uncertainty,
          {"m", "what the mesh leaves open in the advance of the front, from a coarser mesh"});
  v.maybe("limits", r.limits, {"", "what the ends of the box limit"});
}

/// FEM results at one time.
struct TimedReduction {
  double time = 0;               ///< [s]
  std::string folder;            ///< folder of its results within that of the run
  std::vector<ElementRun> runs;  ///< by flow rule
  std::optional<std::string> error;
};
void describe(auto& v, As<TimedReduction> auto& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("folder", r.folder, {"", "folder of its results"});
  v.key("runs", r.runs, {"", "strength reductions by flow rule"});
  v.key("error", r.error, {"", "why there is no answer"});
}

/// Interval of time in which the equilibrium of FEM with the given strength is lost.
struct EquilibriumLoss {
  std::optional<double> from;  ///< [s]; nullopt if there is no equilibrium at time 0
  std::optional<double> to;    ///< [s]; nullopt if equilibrium is never lost
  int trials = 0;              ///< number of equilibria computed in the bisection
};
void describe(auto& v, As<EquilibriumLoss> auto& r) {
  v.key("from", r.from, {"s", "the last time with equilibrium"});
  v.key("to", r.to, {"s", "the first time without"});
  v.key("trials", r.trials, {"", "equilibria that were looked for"});
}

struct Timeline {
  double duration = 0;               ///< [s]
  std::optional<std::string> start;  ///< date of time 0, "2023-03-01"; nullopt if not given
  double target = 1;
  std::vector<TimedFactor> factors;  ///< in order of time
  std::optional<double> least;       ///< smallest factor
  std::optional<double> least_time;  ///< [s]
  bool fails_from_start = false;     ///< the factor at time 0 is below the target
  std::optional<FailureTime> failure;
  bool chosen = false;  ///< the times were selected by the program, not given
  std::optional<double>
      distance;  ///< largest estimated error of linear interpolation between two times, relative to the factor
  std::vector<WaterState> states;              ///< at the times of the factors
  std::vector<TimedReduction> elements;        ///< in order of time
  std::optional<EquilibriumLoss> equilibrium;  ///< if it is the criterion of the release
  bool pool_loading = false;                   ///< ponded water loads saturated soil
  std::vector<Release> releases;               ///< the first is that of the run itself
  std::vector<std::string> notes;
  Season weather;
  double step_error = 0;  ///< largest difference between prediction and solution of a seepage step [m of water]
  double seepage_seconds = 0, search_seconds = 0;
};
void describe(auto& v, As<Timeline> auto& r) {
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
  v.key("elements", r.elements, {"", "factors of safety by FEM in time"});
  v.key("equilibrium", r.equilibrium, {"", "loss of equilibrium by FEM"});
  v.key("pool_loading", r.pool_loading, {"", "whether the weight of pools compresses saturated soil"});
  v.key("releases", r.releases, {"", "MPM runs that start from the timeline, the run itself first"});
  v.key("notes", r.notes, {"", "what must be known of it"});
  v.key("weather", r.weather, {"", "water that came, went and is stored"});
  v.key("step_error", r.step_error, {"m", "the largest error of a step of the seepage, by its prediction"});
  v.key("seepage_seconds", r.seepage_seconds, {"s", "seconds of the seepage"});
  v.key("search_seconds", r.search_seconds, {"s", "seconds of the searches"});
}

/// Critical surfaces at one time, by method.
struct SearchedMoment {
  double time = 0;  ///< [s]
  std::vector<SlipSurface> circular, noncircular, given;
  std::string error;  ///< why the search failed; empty if it did not
};
void describe(auto& v, As<SearchedMoment> auto& r) {
  v.key("time", r.time, {"s", "when"});
  v.key("circular", r.circular, {"", "critical circles"});
  v.key("noncircular", r.noncircular, {"", "critical polylines"});
  v.key("given", r.given, {"", "surfaces that the case gives"});
  v.key("error", r.error, {"", "why there is none"});
}

/// timeline.json: the searches that a resumed run reads instead of computing them again.
struct TimelineFile {
  std::string input_hash;
  std::vector<SearchedMoment> moments;
};
void describe(auto& v, As<TimelineFile> auto& r) {
  v.key("input_hash", r.input_hash, {"", "hash of the input"});
  v.key("moments", r.moments, {"", "times that are searched"});
}

/// Returns the FEM results at the time of the smallest factor, by the first flow rule; nullptr if there are none.
const TimedReduction* find_least_reduction(const Timeline& timeline);

/// Sets the smallest factor and the time of failure from the factors of the timeline.
void find_failure(Timeline& timeline);

/// Returns a time such as "2.5 days", followed by " (2023-03-03 12:00)" if the date of time 0 is known.
std::string format_moment(const Timeline& timeline, double time);

/// Returns sentences such as "The factor of safety falls below 1 between 3.38 and 3.94 h, where it is 1.0001 and
/// 0.9990. It is least at 72 h, 0.941."
std::string format_failure(const Timeline& timeline);

/// Returns sentences on the runouts of the releases and their dependence on the time of release; empty if there are
/// none.
std::string format_releases(const Timeline& timeline, const ShownUnits& units);

}  // namespace talus::results
