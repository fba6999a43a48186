// SPDX-License-Identifier: MIT
#pragma once
// The two cone programs of a problem. Unknown are the effective stresses at the corners of the triangles, three each:
// (σx + σy)/2, (σx − σy)/2 and τxy, so that the mean stress of soil without friction is in no cone. The last unknown is
// the cohesion m that every corner lacks: the least m with which there is equilibrium under all loads. The
// slope stands with strengths divided by F where m ≤ 0. (A multiplier of gravity, as in the literature, has no value in
// soil without cohesion; m has one always.)

#include "bounds/check.hpp"
#include "bounds/conic/cones.hpp"
#include "bounds/problem.hpp"
#include "bounds/velocities.hpp"

namespace talus::bounds {

enum class Bound {
  lower,  ///< stresses linear in each triangle, in equilibrium inside, across every edge and with the loads: a field
          ///< that holds
  upper   ///< equilibrium with every quadratic field of velocities on six-node triangles: its multipliers are such a
          ///< field, and the strength is needed at the corners of the triangles only
};

ConicProgram make_program(const Problem& problem, Bound bound, double factor, const Units& units);

/// Asks for multipliers of the cones that are inside them by `room`: with what the solver leaves of its equations they
/// still are inside.
void leave_room(ConicProgram& program, double room);

/// Adds the room to the multipliers of a solution of the changed program. Returns the lack that they prove of the
/// unchanged one.
double use_room(const ConicProgram& program, double room, ConicSolution& solution);

/// The derivative of the least m by the factor, at a solution of that program.
double find_lack_rate(const Problem& problem, Bound bound, double factor, const Units& units,
                      const ConicSolution& solution);

// From what the solver found to fields that a check can be asked of.

/// The field of a solution of the lower bound's program, moved by the least squares of stress into equilibrium.
StressField read_stress(const Problem& problem, const ConicProgram& program, const ConicSolution& solution,
                        const Units& units);

/// The field of a solution of the upper bound's program for this factor: its velocities, moved by the least squares
/// into constant volume where the soil has no friction, and opened everywhere by as much as the worst corner lacks of
/// its flow rule. `opening` is that of the mesh.
VelocityField read_velocity(const Problem& problem, double factor, const ConicSolution& solution,
                            OpeningSearch& opening);

}  // namespace talus::bounds
