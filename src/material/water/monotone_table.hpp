// SPDX-License-Identifier: MIT
#pragma once
// A monotone curve through given points, for laboratory data of retention and conductivity. It has arrays of fixed size
// so that kernels can use it; the interval is selected without a branch per lane.

#include <array>
#include <string>
#include <vector>

#include "base/lane.hpp"

namespace talus::material {

enum class Interpolation {
  linear,  ///< piecewise linear
  smooth   ///< monotone cubics (PCHIP of Fritsch and Butland 1984): no overshoot, continuous slope
};

/// Value and slope of a curve at a point.
template <class T>
struct CurvePoint {
  T value;
  T slope;
};

struct MonotoneTable {
  static constexpr int capacity = 48;

  int size = 0;
  std::array<double, capacity> x{};                 ///< strictly increasing
  std::array<std::array<double, capacity>, 4> c{};  ///< of interval k: c0 + d(c1 + d(c2 + d c3)), d = x - x[k]

  double first_x() const { return x[0]; }
  double last_x() const { return x[static_cast<std::size_t>(size - 1)]; }

  /// Evaluates the curve, which is constant before the first and after the last point.
  template <class T>
  TALUS_KERNEL CurvePoint<T> evaluate(T at) const {
    const double low = x[0], high = x[static_cast<std::size_t>(size - 1)];
    const T inside = lane_max(T(low), lane_min(T(high), at));
    T start(low), c0(c[0][0]), c1(c[1][0]), c2(c[2][0]), c3(c[3][0]);
    for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(size); ++k) {
      const auto beyond = inside > T(x[k]);
      start = select(beyond, T(x[k]), start);
      c0 = select(beyond, T(c[0][k]), c0);
      c1 = select(beyond, T(c[1][k]), c1);
      c2 = select(beyond, T(c[2][k]), c2);
      c3 = select(beyond, T(c[3][k]), c3);
    }
    const T d = inside - start;
    const auto outside = !(at > T(low)) || at > T(high);
    return {c0 + d * (c1 + d * (c2 + d * c3)), select(outside, T(0.0), c1 + d * (2.0 * c2 + d * (3.0 * c3)))};
  }
};

/// Makes the curve through `points`, pairs of x and value. Throws Error (wrong_input) with a sentence that begins with
/// `what` if there are fewer than two points or more than the capacity, if x does not increase, or if the values are
/// not monotone.
MonotoneTable make_table(const std::vector<std::array<double, 2>>& points, Interpolation interpolation,
                         const std::string& what);

}  // namespace talus::material
