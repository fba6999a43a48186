// SPDX-License-Identifier: MIT
#pragma once
// An interior point method for second-order cone programs.

#include "bounds/conic/cones.hpp"

namespace talus::bounds {

// Rows and columns of about one: the same program in other units.

/// x = column · x' and (A x + s − b)' = row · (A x + s − b); the rows of a cone have one factor. The cost is multiplied
/// by `cost`, and the right side by `right`.
struct Equilibration {
  std::vector<double> row, column;
  double cost = 1, right = 1;
};

/// Ruiz' iteration on `program`, which is changed.
Equilibration equilibrate(ConicProgram& program);

/// Homogeneous self-dual embedding, scaling of Nesterov and Todd, corrector of Mehrotra: every program ends with a
/// solution, with the proof that it has none, or with a sentence. `start`: the x, s and z of a near program of the same
/// size, which are moved inside the cones; none begins anew. Throws Error (interrupted) when a signal arrives. Source:
/// Andersen, Roos and Terlaky, Math. Program. 95 (2003); Goulart and Chen, Clarabel (2024).
ConicSolution solve(const ConicProgram& program, const ConicOptions& options, const ConicSolution* start = nullptr);

}  // namespace talus::bounds
