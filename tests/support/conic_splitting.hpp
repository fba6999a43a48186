// SPDX-License-Identifier: MIT
#pragma once
// Reference solver of cone programs, independent of src/bounds/conic: the alternating direction method of multipliers
// on dense matrices.

#include <Eigen/Dense>

#include "bounds/conic/cones.hpp"

namespace talus::bounds {

/// Dense A of a program.
Eigen::MatrixXd make_dense(const ConicProgram& program);

/// The nearest point of the cones to s; 0 in the rows of equations.
Eigen::VectorXd project(const ConicProgram& program, const Eigen::VectorXd& s);

/// x by the alternating direction method of multipliers (O'Donoghue et al., J. Optim. Theory Appl. 169, 2016, without
/// the embedding), for small programs that have a solution.
Eigen::VectorXd split(const ConicProgram& program, int iterations);

}  // namespace talus::bounds
