// SPDX-License-Identifier: MIT
// Distances from segments and triangles against a dense grid of their points, and the nearest of many by comparison
// with all.

#include <gtest/gtest.h>

#include <algorithm>

#include "site/mesh_sides.hpp"
#include "support/draw.hpp"

namespace talus::site {
namespace {

template <int D>
Vec<D> draw_point(support::Draw& draw, double size) {
  Vec<D> x;
  for (double& c : x) c = draw(-size, size);
  return x;
}

/// The distance from the nearest of the points Σ w_k x_k on a grid of weights.
template <int D>
double search_distance(const std::array<Vec<D>, D>& corners, const Vec<D>& x) {
  constexpr int steps = 300;
  double shortest = 1e300;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= (D == 3 ? steps - i : 0); ++j) {
      const double weights[] = {1 - double(i + j) / steps, double(i) / steps, double(j) / steps};
      Vec<D> r = x;
      for (std::size_t k = 0; k < D; ++k)
        for (std::size_t d = 0; d < D; ++d) r[d] -= weights[k] * corners[k][d];
      shortest = std::min(shortest, norm(r));
    }
  }
  return shortest;
}

template <int D>
void check_distances() {
  support::Draw draw(D);
  for (int n = 0; n < 50; ++n) {
    std::array<Vec<D>, D> corners;
    for (auto& c : corners) c = draw_point<D>(draw, 1);
    const Vec<D> x = draw_point<D>(draw, 2);
    const double found = search_distance<D>(corners, x), exact = find_distance<D>(corners, x);
    EXPECT_LE(exact, found + 1e-12);
    EXPECT_GT(exact, found - 2e-2);
  }
}

TEST(NearestSide, DistanceIsThatOfTheNearestPoint) {
  check_distances<2>();
  check_distances<3>();
}

TEST(NearestSide, OfManyIsTheSameAsByLookingAtAll) {
  support::Draw draw(7);
  std::vector<LabelledSide<3>> sides;
  for (int n = 0; n < 200; ++n) {
    const Vec<3> place = draw_point<3>(draw, 10);
    std::array<Vec<3>, 3> corners;
    for (auto& c : corners) {
      c = draw_point<3>(draw, 1);
      for (std::size_t d = 0; d < 3; ++d) c[d] += place[d];
    }
    sides.push_back(make_labelled_side<3>(corners, n));
  }
  const SideSet<3> set(sides);
  std::size_t guess = 0;
  for (int n = 0; n < 300; ++n) {
    const Vec<3> x = draw_point<3>(draw, 12);
    const auto nearest = std::min_element(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
      return find_distance<3>(a.corners, x) < find_distance<3>(b.corners, x);
    });
    const NearestSides found = set.find_nearest(x, 1e-9, guess);
    ASSERT_EQ(found.labels.size(), 1u);
    EXPECT_EQ(found.labels[0], nearest->label);
    EXPECT_EQ(static_cast<int>(guess), nearest->label);
  }
}

}  // namespace
}  // namespace talus::site
