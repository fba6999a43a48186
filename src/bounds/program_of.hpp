// SPDX-License-Identifier: MIT
#pragma once
// The cone programs of both bounds (T21.2). The unknowns are the effective stresses at the corners of the triangles,
// three each: (σx + σy)/2, (σx − σy)/2 and τxy, so that the mean stress of soil without friction is in no cone. The
// last unknown is the cohesion m that every corner lacks, and the program minimises it under equilibrium with all
// loads. The slope is stable with strengths divided by F where m ≤ 0. (The usual multiplier of gravity has no finite
// value in soil without cohesion; m always has one.)

#include "bounds/check.hpp"
#include "bounds/conic/cones.hpp"
#include "bounds/problem.hpp"
#include "bounds/velocities.hpp"

namespace talus::bounds {

enum class Bound {
  lower,  ///< a statically admissible stress field, linear in each triangle, in equilibrium inside, across every edge
          ///< and with the loads
  upper   ///< equilibrium in the mean with every quadratic velocity field on six-node triangles; the multipliers are a
          ///< kinematically admissible velocity field, and the criterion is imposed at the corners only
};

ConicProgram make_program(const Problem& problem, Bound bound, double factor, const Units& units);

/// Changes the cost so that the multipliers of the solution lie inside their cones by `room` and stay inside in spite
/// of the solver's residual.
void leave_room(ConicProgram& program, double room);

/// Adds the room to the multipliers of a solution of the changed program. Returns the lack that they prove for the
/// original one.
double use_room(const ConicProgram& program, double room, ConicSolution& solution);

/// Returns the derivative of the least m by the factor, at a solution of that program.
double find_lack_rate(const Problem& problem, const ConicProgram& program, Bound bound, double factor,
                      const Units& units, const ConicSolution& solution);

/// Returns what the criterion of every corner leaves of the unknowns of a program of either bound (the first of its
/// rows in a cone; the others are the shear stresses), in the order of the cones at the end of make_program().
std::vector<double> find_slacks(const Problem& problem, Bound bound, double factor, const Units& units,
                                const std::vector<double>& unknowns);

// Conversion of solutions to fields that check() can verify.

/// Returns the stress field of a solution of the lower bound, moved into equilibrium by least squares.
StressField read_stress(const Problem& problem, const ConicProgram& program, double factor,
                        const ConicSolution& solution, const Units& units);

/// Returns the velocity field of a solution of the upper bound for this factor, moved by least squares to constant
/// volume where the soil has no friction, and opened everywhere by as much as the worst corner violates its flow rule.
/// `opening` belongs to the mesh.
VelocityField read_velocity(const Problem& problem, double factor, const ConicSolution& solution,
                            OpeningSearch& opening);

}  // namespace talus::bounds
