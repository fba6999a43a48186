// SPDX-License-Identifier: MIT
#pragma once
// The fields of both bounds, corrected after the solver, and the factors that they prove.

#include <string>

#include "bounds/conic/program.hpp"
#include "bounds/program_of.hpp"

namespace talus::bounds {

/// Effective stress at the corners of the triangles.
struct StressField {
  std::vector<std::array<Stress, 3>> stress;  ///< [Pa]
};

/// Velocities at the nodes of the six-node triangles, of any size.
struct VelocityField {
  Velocities mesh;
  std::vector<Vec<2>> velocity;
};

/// The field of a solution of the lower bound's program, moved by the least squares of stress into equilibrium.
StressField read_stress(const Problem& problem, const ConicProgram& program, const ConicSolution& solution,
                        const Units& units);

/// The field of a solution of the upper bound's program for this factor: its velocities, moved by the least squares
/// into constant volume where the soil has no friction, and opened everywhere by as much as the worst corner lacks of
/// its flow rule.
VelocityField read_velocity(const Problem& problem, double factor, const ConicSolution& solution);

}  // namespace talus::bounds
