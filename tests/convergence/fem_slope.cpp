// SPDX-License-Identifier: MIT
// The factor of safety by FEM under mesh refinement, in plane strain and extruded.

#include <gtest/gtest.h>

#include <cmath>

#include "support/solid_model.hpp"

namespace talus {
namespace {

support::SoilSection make_section(double size) {
  return {{{0, 0}, {14, 0}, {14, 2}, {11, 2}, {4, 6}, {0, 6}}, 4e3, 25, 25, 18e3, 1e7, 0.3, size};
}

template <int D>
double find_factor(const support::SoilSection& section, double resolution = 0.004) {
  const support::SolidSlope<D> slope(section);
  fem::ReductionOptions options;
  options.from = 1.3, options.to = 1.7, options.resolution = resolution;
  return fem::reduce_strength<D>(slope.model, options).factor;
}

TEST(SolidSlopeMesh, FactorComesDownWithTheMeshAndSettles) {
  std::vector<double> f;
  for (const double size : {1.6, 0.8, 0.4}) f.push_back(find_factor<2>(make_section(size)));
  EXPECT_GT(f[0], f[1]);
  EXPECT_GT(f[1], f[2]);
  EXPECT_LT(f[1] - f[2], 0.7 * (f[0] - f[1]));
  EXPECT_LT(f[1] - f[2], 0.025 * f[2]);
}

TEST(SolidSlopeMesh, ExtrudedSlopeHasTheFactorOfItsSection) {
  // Tetrahedra of a size are stiffer than triangles of that size: 3 % at 1.2 m, 1.4 % at 0.8 m.
  auto section = make_section(0.8);
  const double plane = find_factor<2>(section, 0.01);
  section.thickness = 0.8;
  const double extruded = find_factor<3>(section, 0.01);
  EXPECT_NEAR(extruded, plane, 0.02 * plane);
}

}  // namespace
}  // namespace talus
