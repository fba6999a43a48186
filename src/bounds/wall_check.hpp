// SPDX-License-Identifier: MIT
#pragma once
// Verification of the parts of walls in the fields of both bounds, from stresses and velocities alone.

#include <vector>

#include "bounds/check.hpp"
#include "bounds/problem.hpp"

namespace talus::bounds {

struct WallStatics {
  double factor = unlimited;  ///< of the interfaces
  double imbalance = 0;       ///< force and moment at the toes, over the extent of the section [Pa]
  bool holds = true;          ///< the walls are sound, and no beam or strut exceeds its strength
};

/// Integrates the tractions on each wall from its head on, and compares force and moment with the strength of the beam.
/// `least`: smallest cohesion and tensile strength of interfaces [Pa].
WallStatics check_walls(const Problem& problem, const StressField& field, double extent, double least);

/// Relative velocity of soil and wall at a contact, times its weight.
struct ContactMotion {
  InterfaceStrength strength;
  double weight = 0;             ///< [m]
  double opening = 0, slip = 0;  ///< [m²/s]
};

struct WallKinematics {
  std::vector<ContactMotion> contacts;
  double work = 0;         ///< of loads on walls, and of pore water in the gaps
  double dissipation = 0;  ///< of beams and struts, which F does not divide
  /// Largest velocity of what does not yield: elongation, rotation and jump of a beam, and shortening of a strut,
  /// without a limit of the force for it.
  double held = 0;
  bool is_sound = true;
};

/// Evaluates the motion of the walls and of the soil beside them.
WallKinematics check_walls(const Problem& problem, const VelocityField& field);

/// Returns the velocity of a wall at one of its nodes, of the part below.
Vec<2> find_wall_velocity(const VelocityField& field, std::size_t wall, std::size_t node);

}  // namespace talus::bounds
