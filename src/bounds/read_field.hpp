// SPDX-License-Identifier: MIT
#pragma once
// From what the solver found to fields that a check can be asked of.

#include "bounds/conic/program.hpp"
#include "bounds/field.hpp"
#include "bounds/opening.hpp"

namespace talus::bounds {

/// The field of a solution of the lower bound's program, moved by the least squares of stress into equilibrium.
StressField read_stress(const Problem& problem, const ConicProgram& program, const ConicSolution& solution,
                        const Units& units);

/// The field of a solution of the upper bound's program for this factor: its velocities, moved by the least squares
/// into constant volume where the soil has no friction, and opened everywhere by as much as the worst corner lacks of
/// its flow rule. `opening` is that of the mesh.
VelocityField read_velocity(const Problem& problem, double factor, const ConicSolution& solution,
                            OpeningSearch& opening);

}  // namespace talus::bounds
