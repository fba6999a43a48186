// SPDX-License-Identifier: MIT
// The polynomial for the principal stresses has the accuracy that its header states.

#include <gtest/gtest.h>

#include <cmath>

#include "material/principal_stress.hpp"

namespace talus {

TEST(PrincipalStress, PolynomialHasItsStatedAccuracy) {
  const material::CosineThird cosine;
  for (int i = 0; i <= 1000; ++i) {
    const double u = i / 1000.0;
    EXPECT_NEAR(cosine(u), static_cast<double>(std::cos(2 / 3.0L * std::acos(static_cast<long double>(u)))), 2e-15)
        << u;
  }
}

}  // namespace talus
