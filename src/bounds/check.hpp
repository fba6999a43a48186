// SPDX-License-Identifier: MIT
#pragma once
// What a field proves, by itself: nothing here knows how it was found.

#include "bounds/problem.hpp"
#include "bounds/velocities.hpp"

namespace talus::bounds {

// The fields of both bounds.

/// Effective stress at the corners of the triangles.
struct StressField {
  std::vector<std::array<Stress, 3>> stress;  ///< [Pa]
};

/// Velocities at the nodes of the six-node triangles, of any size.
struct VelocityField {
  Velocities mesh;
  std::vector<Vec<2>> velocity;
};

/// What rounding may leave of equilibrium, in units of stress.
inline constexpr double rounding = 1e-8;

/// Cohesion or largest tension that soil is taken to have where it is given less, in units of stress: at a free surface
/// soil without them bears no stress at all, and a field may only be so near to none.
inline constexpr double least_strength = 1e-6;

struct StaticCheck {
  double factor = 0;  ///< strengths divided by it hold the field everywhere
  double imbalance =
      0;  ///< largest: force per volume inside (times the extent), traction across edges and on the border [Pa]
  bool holds = false;  ///< imbalance is rounding
};

/// Divergence, tractions on both sides of every edge and on the border, and the least factor of all corners. The
/// criterion is convex, so what holds at the corners holds everywhere between them.
StaticCheck check(const Problem& problem, const StressField& field);

struct KinematicCheck {
  double factor = 0;  ///< at this one, and above, the loads do more work than the soil can take up; infinite: for none
  double work = 0;    ///< of weights, loads and pore pressures [W/m per unit of velocity]
  double dissipation = 0;  ///< with strengths divided by the factor
  bool holds = false;      ///< the field is continuous, supports are held, and there is such a factor
};

/// Strain rates at the corners, linear between them; the flow rule there; work exactly; dissipation, which is convex,
/// by corners, so not less than it is.
KinematicCheck check(const Problem& problem, const VelocityField& field);

}  // namespace talus::bounds
