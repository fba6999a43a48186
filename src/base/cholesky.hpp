// SPDX-License-Identifier: MIT
#pragma once
// Cholesky's factorisation of a small matrix, for files that need nothing else of Eigen: its templates cost seconds
// each.

#include <optional>
#include <vector>

namespace talus {

/// The lower triangle L of L Lᵀ = C, both row by row; nothing where C is not positive definite.
std::optional<std::vector<double>> factorise(const std::vector<double>& symmetric, int size);

}  // namespace talus
