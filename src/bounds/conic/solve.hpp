// SPDX-License-Identifier: MIT
#pragma once
// An interior point method for second-order cone programs, and the equilibration of a program.

#include "bounds/conic/cones.hpp"

namespace talus::bounds {

// Equilibration: a program of entries of about one, equivalent to the given one in other units.

/// The scaling x = column · x' and (A x + s − b)' = row · (A x + s − b), in which the rows of a cone have one factor.
/// The cost is multiplied by `cost`, and the right-hand side by `right`.
struct Equilibration {
  std::vector<double> row, column;
  double cost = 1, right = 1;
};

/// Equilibrates `program` in place by Ruiz' iteration and returns the scaling.
Equilibration equilibrate(ConicProgram& program);

/// Solves a program by the homogeneous self-dual embedding with the scaling of Nesterov and Todd and the corrector of
/// Mehrotra. The outcome is a solution, a certificate that there is none, or the reason of a failure. `start`: the x, s
/// and z of a similar program of the same size, which are shifted inside the cones; nullptr: a cold start. Throws Error
/// (interrupted) after a signal. Sources: Andersen, Roos and Terlaky, Math. Program. 95 (2003); Goulart and Chen,
/// Clarabel (2024).
ConicSolution solve(const ConicProgram& program, const ConicOptions& options, const ConicSolution* start = nullptr);

}  // namespace talus::bounds
