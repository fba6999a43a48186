// SPDX-License-Identifier: MIT
#pragma once
// The cohesion that roots across a shear plane give to the soil: Wu and Waldron's sum and a fibre bundle.
// Symbols and sources: docs/theory/17-root-cohesion.md.

#include <vector>

namespace talus::material {

/// Roots of one diameter that cross a shear plane.
struct RootClass {
  double diameter = 0;    ///< d [m]
  double area_ratio = 0;  ///< a, cross-section of these roots over that of the soil [-]
  double strength = 0;    ///< T, tensile strength [Pa]
};

/// c_r = k' Σ T_i a_i (T17.2): all roots break at once. `orientation`: k' [-].
double find_wu_waldron_cohesion(const std::vector<RootClass>& roots, double orientation);

/// c_r = k' max_j F_j Σ_{i not weaker than j} n_i (T17.4), F = T π d²/4 and n = a/(π d²/4): the load is shared equally
/// by the roots that are left, and the root that bears least breaks first. Never above Wu and Waldron's.
double find_fibre_bundle_cohesion(std::vector<RootClass> roots, double orientation);

}  // namespace talus::material
