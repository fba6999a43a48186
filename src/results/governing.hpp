// SPDX-License-Identifier: MIT
#pragma once
// The factor that governs. All code that needs one surface or one factor takes it from here.

#include <optional>
#include <string>

#include "results/run.hpp"

namespace talus::results {

/// The slip surface of slices that governs.
struct GoverningSurface {
  const CriticalSurface* found;  ///< has a factor
  SurfaceSource source;
  std::string name;  ///< as MethodRow::surface: "lem.noncircular.spencer"
};

/// The admissible surface with the smallest factor, by the methods with the lowest rank_equilibrium() that found one:
/// among circles, polylines, the surfaces of the case, and those that slices improved from other methods. Surfaces
/// that a search would refuse count only where there is no other, and surfaces whose factor limit analysis proves
/// impossible never. Nothing: slices have no such factor.
std::optional<GoverningSurface> find_governing_surface(const RunResult& run);
/// The same. `methods`: where there are improved surfaces; nullptr: there are none.
std::optional<GoverningSurface> find_governing_surface(const SliceResult& slices, const MethodComparison* methods);

/// Marks the factors that limit analysis proves impossible, and keeps its interval.
void take_referee(Referee referee, SliceResult& slices);

/// The same as the next, of what was found at one time.
std::optional<double> find_slices_factor(const SliceResult& slices, const MethodComparison* methods);
/// The factor of limit equilibrium: that of the governing surface. Where limit analysis proves all factors impossible,
/// its lower bound if one of them lies below it, else its upper bound.
std::optional<double> find_slices_factor(const RunResult& run);

/// "critical polyline", "given surface 'bed'".
std::string name_surface(const GoverningSurface& surface);

/// The factor of safety of the material points: at frozen geometry, or else by the first criterion that found one.
std::optional<double> find_points_factor(const RunResult& run);
/// The strength reduction by finite elements that stands for them: with ψ as given before ψ = φ, and none with a factor
/// that is proven too low; nullptr where there is none.
const ElementRun* find_governing_elements(const RunResult& run);

/// The end of a proven interval that the main factor is: a lower one where nothing else is possible, an upper one below
/// what all other methods found. Nothing: it is a method's own factor.
enum class ProvenEnd { lower, upper };
std::optional<ProvenEnd> find_proven_end(const RunResult& run);
inline bool is_main_factor_proven(const RunResult& run) {
  return find_proven_end(run).has_value();
}

}  // namespace talus::results
