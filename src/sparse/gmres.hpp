// SPDX-License-Identifier: MIT
#pragma once
// Iterative solution of linear systems by GMRES (Saad and Schultz 1986), with the factors of a similar matrix: of an
// earlier one where new factors cost more (FEM in 3D), or of one whose diagonal is shifted (limit analysis).

#include <functional>
#include <vector>

namespace talus::sparse {

/// Replaces x by the product of a matrix and x. Returns false if the product is not finite.
using LinearMap = std::function<bool(std::vector<double>& x)>;

/// Solves A x = b until the norm of the residual is at most `tolerance` times that of b, by at most `most` iterations;
/// `invert` approximates A⁻¹. Returns the norm of the residual over that of b; infinity if there is no finite x.
double solve_by_gmres(const LinearMap& apply, const LinearMap& invert, const std::vector<double>& b, double tolerance,
                      int most, std::vector<double>& x);

}  // namespace talus::sparse
