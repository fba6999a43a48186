// SPDX-License-Identifier: MIT
// The two root bundle models: hand calculations, a bundle pulled root by root, and the bound between the two models.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "material/rooted_mohr_coulomb.hpp"
#include "support/draw.hpp"

namespace talus {
namespace {

using material::find_fibre_bundle_cohesion;
using material::find_wu_waldron_cohesion;
using material::RootClass;
using support::Draw;

TEST(RootBundle, GivesTheHandValues) {
  // 1 mm roots bear 40 MPa · 0.7854 mm² = 31.42 N, 127.3 a square metre; 5 mm roots 15 MPa · 19.63 mm² = 294.5 N, 20.37
  // a square metre. All bear 31.42 N: 147.7 · 31.42 = 4640 Pa. The thick ones alone: 20.37 · 294.5 = 6000 Pa.
  const std::vector<RootClass> mixed{{1e-3, 1e-4, 40e6}, {5e-3, 4e-4, 15e6}};
  EXPECT_NEAR(find_wu_waldron_cohesion(mixed, 1.2), 1.2 * (4000 + 6000), 1e-9);
  EXPECT_NEAR(find_fibre_bundle_cohesion(mixed, 1.2), 1.2 * 6000, 1e-9);
  // With ten times as many thin roots the bundle breaks when the first of them does: 1273 + 20.4 times 31.42 N.
  const std::vector<RootClass> thin{{5e-3, 4e-4, 15e6}, {1e-3, 1e-3, 40e6}};
  EXPECT_NEAR(find_fibre_bundle_cohesion(thin, 1), 40640, 1e-6);
  EXPECT_EQ(find_fibre_bundle_cohesion({}, 1.2), 0);
}

/// Pulls single roots as Pollen and Simon do: equal loads, the weakest breaks, its load goes to the others.
double pull_bundle(std::vector<double> forces) {
  double largest = 0;
  while (!forces.empty()) {
    const auto weakest = std::min_element(forces.begin(), forces.end());
    largest = std::max(largest, *weakest * static_cast<double>(forces.size()));
    forces.erase(weakest);
  }
  return largest;
}

TEST(RootBundle, BreaksAsABundleThatIsPulledRootByRoot) {
  Draw draw(5);
  for (int n = 0; n < 200; ++n) {
    std::vector<RootClass> classes;
    std::vector<double> forces;  // on one square metre
    const int kinds = 1 + static_cast<int>(draw(0, 6));
    for (int k = 0; k < kinds; ++k) {
      const double diameter = draw(0.2e-3, 8e-3), area = 0.25 * std::numbers::pi * diameter * diameter;
      const double strength = 20e6 * std::pow(diameter / 1e-3, -0.7) * draw(0.7, 1.3);
      const int roots = 1 + static_cast<int>(draw(0, 40));
      classes.push_back({diameter, roots * area, strength});
      forces.insert(forces.end(), static_cast<std::size_t>(roots), strength * area);
    }
    const double expected = pull_bundle(forces);
    EXPECT_NEAR(find_fibre_bundle_cohesion(classes, 1), expected, 1e-9 * expected);
  }
}

TEST(RootBundle, NeverExceedsWuAndWaldronAndEqualsItForEqualRoots) {
  Draw draw(6);
  for (int n = 0; n < 2000; ++n) {
    std::vector<RootClass> classes;
    double strongest = 0;
    for (int k = 0; k < 8; ++k) {
      classes.push_back({draw(0.2e-3, 10e-3), draw(1e-5, 1e-3), draw(5e6, 80e6)});
      strongest = std::max(strongest, classes.back().strength * classes.back().area_ratio);
    }
    const double bundle = find_fibre_bundle_cohesion(classes, 1.1), sum = find_wu_waldron_cohesion(classes, 1.1);
    EXPECT_LT(bundle, sum * (1 + 1e-12));
    EXPECT_GT(bundle, 1.1 * strongest * (1 - 1e-12));  // what one class bears alone
    // The same forces by any other order of the classes.
    std::reverse(classes.begin(), classes.end());
    EXPECT_NEAR(find_fibre_bundle_cohesion(classes, 1.1), bundle, 1e-9 * bundle);
  }
  const std::vector<RootClass> equal{{2e-3, 3e-4, 25e6}};
  EXPECT_NEAR(find_fibre_bundle_cohesion(equal, 1.2), find_wu_waldron_cohesion(equal, 1.2), 1e-9);
}

}  // namespace
}  // namespace talus
