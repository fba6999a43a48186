// SPDX-License-Identifier: MIT
#pragma once
// Small fixed-size vectors of coordinates, and the Cholesky factorisation of a small matrix.

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

// The Cholesky factorisation has its own translation unit, because including Eigen costs seconds of compile time per
// file.

/// Returns the lower triangle L of L Lᵀ = C, row by row as C is given; std::nullopt if C is not positive definite.
std::optional<std::vector<double>> factorise(const std::vector<double>& symmetric, int size);

}  // namespace talus
