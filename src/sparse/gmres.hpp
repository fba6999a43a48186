// SPDX-License-Identifier: MIT
#pragma once
// Iterative solution of linear systems by GMRES (Saad and Schultz 1986) with the factors of a similar matrix, which is
// cheaper than new factors where these are large: on three-dimensional meshes.

#include <functional>
#include <vector>

namespace talus::sparse {

/// Replaces x by the product of a matrix and x. Returns false if the product is not finite.
using LinearMap = std::function<bool(std::vector<double>& x)>;

/// Solves A x = b until the norm of the residual is at most `tolerance` times that of b; `invert` approximates A⁻¹.
/// Returns false if `most` iterations do not suffice; x is then undefined.
bool solve_by_gmres(const LinearMap& apply, const LinearMap& invert, const std::vector<double>& b, double tolerance,
                    int most, std::vector<double>& x);

}  // namespace talus::sparse
