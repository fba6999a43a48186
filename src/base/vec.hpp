// SPDX-License-Identifier: MIT
#pragma once
// Small fixed vectors of coordinates.

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/portable.hpp"

namespace talus {

template <int D>
using Vec = std::array<double, D>;

template <std::size_t D>
TALUS_PORTABLE double dot(const std::array<double, D>& a, const std::array<double, D>& b) {
  double s = 0;
  for (std::size_t d = 0; d < D; ++d) s += a[d] * b[d];
  return s;
}

template <std::size_t D>
TALUS_PORTABLE double norm(const std::array<double, D>& a) {
  return std::sqrt(dot(a, a));
}

// Cholesky's factorisation of a small matrix, for files that need nothing else of Eigen: its templates cost seconds
// each.

/// The lower triangle L of L Lᵀ = C, both row by row; nothing where C is not positive definite.
std::optional<std::vector<double>> factorise(const std::vector<double>& symmetric, int size);

}  // namespace talus
