// SPDX-License-Identifier: MIT
#pragma once
// Small fixed vectors of coordinates.

#include <array>
#include <cmath>

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

}  // namespace talus
