// SPDX-License-Identifier: MIT
#pragma once
// Rules that select the governing slip surface and the governing factor of safety of a run. All other code uses these
// functions.

#include <optional>
#include <string>

#include "results/run.hpp"

namespace talus::results {

/// The governing slip surface of LEM.
struct GoverningSurface {
  const CriticalSurface* found;  ///< never null; its factor is set
  SurfaceSource source;
  std::string name;  ///< as MethodRow::surface, such as "lem.noncircular.spencer"
};

/// Returns the admissible surface with the smallest factor among the critical circles and polylines, the surfaces of
/// the case, and the surfaces of other methods that LEM optimised. Of these, the methods with the lowest
/// rank_equilibrium() that have a factor count. Surfaces that a search would reject count only if there is no other;
/// surfaces whose factor limit analysis proves impossible never count. Returns nullopt if no surface remains, or if
/// lower factors were ruled out and the least one left lies more than `most_above_lower` above the lower bound, which
/// governs then: the surface that the search missed has a factor between them. Given surfaces without a search miss
/// none.
std::optional<GoverningSurface> find_governing_surface(const RunResult& run);
/// Same for one LEM result; `methods` has the optimised surfaces and may be null.
std::optional<GoverningSurface> find_governing_surface(const SliceResult& slices, const MethodComparison* methods);

inline constexpr double most_above_lower = 0.03;

/// Returns the reason why the interval of limit analysis is the answer of LEM, such as "no factor by limit equilibrium
/// is possible"; empty if a surface governs or there is no interval.
std::string describe_ruled_out(const RunResult& run);

/// Classifies a surface by the bounds of limit analysis. A surface with supports is too low by the lower bound alone
/// too. Where the pull of an active support has a part along the sliding of the base, its prestress drives the mass in
/// LEM and is zero in limit analysis: the surface is not too low.
Verdict judge(const Referee& referee, const CriticalSurface& surface);

/// Marks the factors outside the interval of limit analysis, and stores its interval in `slices`.
void take_referee(Referee referee, SliceResult& slices);

/// Same as the next function, for the results of one time of a timeline.
std::optional<double> find_slices_factor(const SliceResult& slices, const MethodComparison* methods);
/// Returns the factor of LEM, that of the governing surface. If none governs, returns the lower bound of limit analysis
/// if a factor was ruled out as too low, otherwise its upper bound.
std::optional<double> find_slices_factor(const RunResult& run);

/// Returns a description such as "critical polyline" or "given surface 'bed'".
std::string name_surface(const GoverningSurface& surface, const ShownUnits& units);

/// Returns the factor of safety of MPM: at frozen geometry, otherwise by the first criterion of the displacement curve
/// that gave one.
std::optional<double> find_points_factor(const RunResult& run);
/// Returns the governing strength reduction of FEM: ψ as given before ψ = φ. Runs whose factor limit analysis proves
/// too low are excluded; nullptr if none remains.
const ElementRun* find_governing_elements(const RunResult& run);

/// Returns which bound of limit analysis equals the main factor: a lower bound if all factors of LEM are outside the
/// interval or only limit analysis was run, an upper bound if it is below the factors of all other methods. Returns
/// nullopt if the main factor is that of another method.
enum class ProvenEnd { lower, upper };
std::optional<ProvenEnd> find_proven_end(const RunResult& run);
inline bool is_main_factor_proven(const RunResult& run) {
  return find_proven_end(run).has_value();
}

/// Copies runout and start of a run of MPM that was released from a state of another method.
void take_motion(const RunResult& run, Release& out);

}  // namespace talus::results
