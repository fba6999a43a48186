// SPDX-License-Identifier: MIT
#pragma once
// Verification of the fields of both bounds: the factor that a given field proves, whatever the solver it came from.

#include "bounds/problem.hpp"
#include "bounds/velocities.hpp"

namespace talus::bounds {

// The fields of both bounds.

/// Effective stress at the corners of the triangles, linear between them.
struct StressField {
  std::vector<std::array<Stress, 3>> stress;  ///< [Pa]
  double factor = 1;                          ///< by which the forces of passive supports are divided
  std::vector<double> bars{};                 ///< tension of each bar over the largest one
  std::vector<std::vector<double>> struts{};  ///< compression of the struts of each wall [N]
};

/// Velocities at the nodes of the six-node triangles, in arbitrary units.
struct VelocityField {
  Velocities mesh;
  std::vector<Vec<2>> velocity;
  /// Velocity of each edge of each wall at its upper and its lower end; it is linear between them.
  std::vector<std::vector<std::array<Vec<2>, 2>>> walls{};
};

/// Rounding error allowed in equilibrium, in units of stress.
inline constexpr double rounding = 1e-8;

/// Smallest cohesion and tensile strength that soil is given, in units of stress. At a free surface, soil without them
/// carries no stress at all, which a computed field can only approximate.
inline constexpr double least_strength = 1e-6;

/// Returns the strength with cohesion, tensile strength and that of weak planes not below `least` [Pa].
Strength raise_to(Strength soil, double least);

struct StaticCheck {
  double factor = 0;  ///< the field is admissible everywhere with the strengths divided by it
  double imbalance =
      0;  ///< largest: force per volume inside (times the extent), traction across edges and on the border [Pa]
  bool holds = false;  ///< the imbalance is within rounding
};

/// Checks a stress field: divergence, tractions on both sides of every edge and on the border; and computes the
/// smallest factor of all corners (T21.3), at most that of the field if a support is passive. The criterion is convex,
/// so that it holds between the corners if it holds there.
StaticCheck check(const Problem& problem, const StressField& field);

struct KinematicCheck {
  double factor = 0;       ///< at this factor and above the loads do more work than the dissipation; infinity: none
  double work = 0;         ///< of weights, loads and pore pressures [W/m per unit of velocity]
  double dissipation = 0;  ///< with the strengths divided by the factor
  bool holds = false;      ///< the field is continuous, satisfies the supports, and has a finite factor
};

/// Checks a velocity field: flow rule at the corners, between which strain rates are linear, and exact work. The
/// dissipation is summed over the corners; as it is convex, the sum is not below the exact one.
KinematicCheck check(const Problem& problem, const VelocityField& field);

}  // namespace talus::bounds
