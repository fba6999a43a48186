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
void describe(Visitor& v, TimedFactor& r);

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
void describe(Visitor& v, FailureTime& r);

/// An MPM run that starts from one time of the timeline.
struct Release {
  double time = 0;               ///< [s]
  std::optional<double> factor;  ///< of LEM at that time
  std::string folder;            ///< folder of its results within that of the run; empty for the run itself
  bool rests = false;            ///< the soil was brought to rest before the release
  /// Strength reduction factor of the FEM equilibrium that gives the initial stress; nullopt if it is not from FEM.
  std::optional<double> start_factor;
  std::optional<std::string> error;
  double largest_displacement = 0, moved_volume = 0, front_advance = 0, toe_distance = 0,
         mass_front_advance = 0;              ///< as in Runout
  std::optional<double> front_uncertainty;    ///< discretisation error of the front advance [m]; nullopt if unknown
  std::optional<CoarserRunout> coarser_mesh;  ///< as in Runout
  std::optional<std::vector<std::string>> undetermined;  ///< as in Runout
  std::optional<BoxLimit> limits;                        ///< as in Runout
};
void describe(Visitor& v, Release& r);

/// Returns the measures of the runout with what its meshes leave open.
RunoutEstimates make_estimates(const Release& r);

/// FEM results at one time.
struct TimedReduction {
  double time = 0;               ///< [s]
  std::string folder;            ///< folder of its results within that of the run
  std::vector<ElementRun> runs;  ///< by flow rule
  std::optional<std::string> error;
};
void describe(Visitor& v, TimedReduction& r);

/// Interval of time in which the equilibrium of FEM with the given strength is lost.
struct EquilibriumLoss {
  std::optional<double> from;  ///< [s]; nullopt if there is no equilibrium at time 0
  std::optional<double> to;    ///< [s]; nullopt if equilibrium is never lost
  int trials = 0;              ///< number of equilibria computed in the bisection
};
void describe(Visitor& v, EquilibriumLoss& r);

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
void describe(Visitor& v, Timeline& r);

/// Critical surfaces at one time, by method.
struct SearchedMoment {
  double time = 0;  ///< [s]
  std::vector<SlipSurface> circular, noncircular, given;
  std::string error;  ///< why the search failed; empty if it did not
};
void describe(Visitor& v, SearchedMoment& r);

/// timeline.json: the searches that a resumed run reads instead of computing them again.
struct TimelineFile {
  std::string input_hash;
  std::vector<SearchedMoment> moments;
};
void describe(Visitor& v, TimelineFile& r);

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
