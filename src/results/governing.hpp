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
/// that a search would refuse count only where there is no other. Nothing: slices have no factor.
std::optional<GoverningSurface> find_governing_surface(const RunResult& run);
/// The same. `methods`: where there are improved surfaces; nullptr: there are none.
std::optional<GoverningSurface> find_governing_surface(const SliceResult& slices, const MethodComparison* methods);

/// "critical polyline", "given surface 'bed'".
std::string name_surface(const GoverningSurface& surface);

/// The factor of safety of the material points: at frozen geometry, or else by the first criterion that found one.
std::optional<double> find_points_factor(const RunResult& run);
/// That of the finite elements: with ψ as given before ψ = φ.
std::optional<double> find_elements_factor(const RunResult& run);

/// Whether the main factor is an end of what is proven: the lower one of bounds alone, or an upper one below what all
/// other methods found.
bool is_main_factor_proven(const RunResult& run);

}  // namespace talus::results
