// SPDX-License-Identifier: MIT
// Positions of the material points in an element: exact moments, distances, and the permitted numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "mesh/points.hpp"

namespace talus::mesh {
namespace {

template <int D>
std::array<double, D + 1> compute_shape_functions(const std::array<double, D>& xi) {
  std::array<double, D + 1> shape;
  shape[0] = 1;
  for (int k = 0; k < D; ++k) {
    shape[k + 1] = xi[k];
    shape[0] -= xi[k];
  }
  return shape;
}

/// Means of N_i and N_i N_j over the points against those of the element: 1/(D+1), and (1 + δ_ij)/((D+1)(D+2)).
template <int D>
void expect_exact_moments(int count) {
  const auto points = point_positions<D>(count);
  ASSERT_EQ(static_cast<int>(points.size()), count);
  for (int i = 0; i <= D; ++i) {
    double first = 0;
    for (const auto& xi : points) first += compute_shape_functions<D>(xi)[i] / count;
    EXPECT_NEAR(first, 1.0 / (D + 1), 1e-15) << count << " points, node " << i;
    for (int j = 0; j <= D && count > 1; ++j) {
      double second = 0;
      for (const auto& xi : points) {
        const auto shape = compute_shape_functions<D>(xi);
        second += shape[i] * shape[j] / count;
      }
      EXPECT_NEAR(second, (i == j ? 2.0 : 1.0) / ((D + 1) * (D + 2)), 1e-15) << count << " points";
    }
  }
}

template <int D>
double find_lowest(int count) {
  double lowest = 1;
  for (const auto& xi : point_positions<D>(count)) {
    const auto shape = compute_shape_functions<D>(xi);
    lowest = std::min(lowest, *std::min_element(shape.begin(), shape.end()));
  }
  return lowest;
}

template <int D>
double find_nearest_pair(int count) {
  const auto points = point_positions<D>(count);
  double nearest = 10;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto a = compute_shape_functions<D>(points[i]), b = compute_shape_functions<D>(points[j]);
      double square = 0;  // in the regular simplex of edge √2
      for (int k = 0; k <= D; ++k) square += (a[k] - b[k]) * (a[k] - b[k]);
      nearest = std::min(nearest, std::sqrt(square));
    }
  return nearest;
}

TEST(Points, FillATriangleWithExactMoments) {
  for (int count : allowed_points<2>()) expect_exact_moments<2>(count);
}

TEST(Points, FillATetrahedronWithExactMoments) {
  for (int count : allowed_points<3>()) expect_exact_moments<3>(count);
}

TEST(Points, LieWellInsideAndApart) {
  // In the regular simplex of edge √2 a closest packing of n points has a spacing of √(1/n) and ∛(√2/(3n)).
  // A point nearer to a side than this would leave its element with the first small motion.
  for (int count : allowed_points<2>()) {
    EXPECT_GT(find_lowest<2>(count), 0.08) << count;
    if (count > 1) {
      EXPECT_GT(find_nearest_pair<2>(count), 0.6 * std::sqrt(1.0 / count)) << count;
    }
  }
  for (int count : allowed_points<3>()) {
    EXPECT_GT(find_lowest<3>(count), 0.099) << count;
    if (count > 1) {
      EXPECT_GT(find_nearest_pair<3>(count), 0.6 * std::cbrt(std::sqrt(2.0) / 3 / count)) << count;
    }
  }
}

TEST(Points, OfATriangleAreThoseOfTheIndependentRun) {
  const auto points = point_positions<2>(3);
  const std::vector<std::array<double, 2>> expected{{1. / 6, 1. / 6}, {2. / 3, 1. / 6}, {1. / 6, 2. / 3}};
  EXPECT_EQ(points, expected);
  EXPECT_NEAR(point_positions<3>(4)[0][0], 0.138196601125, 1e-12);
}

TEST(Points, OtherNumbersAreRefusedWithTheChoiceNamed) {
  for (int count : {0, -1, 2, 4, 100}) EXPECT_THROW(point_positions<2>(count), Error) << count;
  try {
    point_positions<3>(3);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("1, 4, 8, 10"), std::string::npos);
  }
}

}  // namespace
}  // namespace talus::mesh
