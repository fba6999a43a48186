// SPDX-License-Identifier: MIT
#pragma once
// Rows and columns of about one: the same program in other units.

#include "bounds/conic/program.hpp"

namespace talus::bounds {

/// x = column · x' and (A x + s − b)' = row · (A x + s − b); the rows of a cone have one factor. The cost is multiplied
/// by `cost`, and the right side by `right`.
struct Equilibration {
  std::vector<double> row, column;
  double cost = 1, right = 1;
};

/// Ruiz' iteration on `program`, which is changed.
Equilibration equilibrate(ConicProgram& program);

}  // namespace talus::bounds
