// SPDX-License-Identifier: MIT
#pragma once
// Shear strength on a plane that a cohesion and a friction angle do not describe: it follows the place, the
// inclination of the plane, or a curved envelope. Laws define it (material/), LEM and limit analysis evaluate it.

#include <array>
#include <functional>
#include <vector>

namespace talus {

/// A plane in soil, and the stresses on it.
struct StrengthPlane {
  std::array<double, 2> at{};  ///< [m]
  double depth = 0;            ///< below the ground, vertically [m]
  double vertical = 0;         ///< σ'_v: weight and permanent loads above, less the pore pressure [Pa]
  double inclination = 0;      ///< of the plane to the horizontal, positive where it rises with x [rad]
  double dip = 0;              ///< the same, positive where it falls in the direction of sliding [rad]
  double normal = 0;           ///< σ'_n, positive in compression [Pa]
};

/// Tangent c + σ'_n tanφ to the strength at one normal stress.
struct StrengthTangent {
  double cohesion = 0;      ///< [Pa]; negative where an envelope is steeper than its secant
  double tan_friction = 0;  ///< [-]
};

struct StrengthLaw {
  std::function<StrengthTangent(const StrengthPlane&)> find_tangent;
  bool is_curved = false;    ///< the tangent depends on σ'_n, so that a factor of safety needs iterations
  bool is_directed = false;  ///< the strength depends on the inclination
  std::vector<double> weak_inclinations{};  ///< of the weakest planes; searches start along them too [rad]
  double straight_below = 0;                ///< σ'_n below which a curved envelope is straight [Pa]
  double tensile_strength = 0;              ///< largest tension of a curved envelope [Pa]
};

}  // namespace talus
