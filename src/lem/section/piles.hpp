// SPDX-License-Identifier: MIT
#pragma once
// Mechanisms of a pile that a slip surface crosses: the soil of the mass flows past it, the pile fails the stable soil,
// rotates, or has plastic hinges (Viggiani 1981).

#include "lem/section/bars.hpp"

namespace talus::lem {

/// The part of a pile on one side of a slip surface.
struct PileSide {
  const BarDiagram* diagram = nullptr;  ///< ultimate pressure of the soil along the pile
  double slip = 0, end = 0;             ///< of the slip surface and of the end of the part, from the head [m]

  /// Returns the sum of the pressure over the part [N/m].
  double compute_strength() const;
};

/// Limits of a pile, per metre of slope; infinite where it has none.
struct PileStrength {
  double moment = 0;   ///< plastic moment [N m/m]
  double shear = 0;    ///< at the slip surface [N/m]
  double lateral = 0;  ///< given resistance [N/m]
};

/// Force of a pile on the mass, and what limits it.
struct PileForce {
  double force = 0;  ///< [N/m]
  BarLimit limit = BarLimit::lateral;
};

/// Returns the largest shear force of a pile with free ends at the slip surface that is in equilibrium with pressures
/// of the soil up to the ultimate ones, in either direction, and with moments up to the plastic one.
PileForce compute_pile_force(const PileSide& mass, const PileSide& stable, const PileStrength& strength);

/// Sums the ultimate pressure of soil along a pile, compute_embedded_pressure(), per metre of slope.
BarDiagram make_embedded_diagram(const Slope& slope, const Bar& pile);

/// Returns the ultimate lateral pressure of soil on one pile per metre of its length [N/m]: that of a single pile,
/// 9 c d + 3 (K_p - K_a) σ'_v d (Broms 1964), at most that of a wall over the spacing, with passive earth pressure in
/// front and active behind. `diameter` 0: that of the wall.
double compute_embedded_pressure(const StrengthTangent& soil, double effective_stress, double spacing, double diameter);

}  // namespace talus::lem
