// SPDX-License-Identifier: MIT
// Detection of faces of cohesionless soil that are steeper than its friction angle.

#include "site/site.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "input/read.hpp"
#include "support/slopes.hpp"

namespace talus::site {
namespace {

std::vector<SteepFace> find(const std::vector<std::string>& changes) {
  std::vector<std::string> all = changes;
  all.push_back("analysis.methods=[\"lem\"]");
  return find_steep_faces(input::read_case_text(support::write_slope("dry", all), "slope.toml").data);
}

TEST(SteepFaces, AreThoseOfSoilWithoutCohesionAboveItsFrictionAngle) {
  // 2:1, 26.6°.
  EXPECT_TRUE(find({"materials.sand.cohesion=0", "materials.sand.friction_angle=27"}).empty());
  EXPECT_TRUE(find({"materials.sand.cohesion=\"1 kPa\"", "materials.sand.friction_angle=20"}).empty());
  const auto faces = find({"materials.sand.cohesion=0", "materials.sand.friction_angle=20"});
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].material, "sand");
  EXPECT_EQ(faces[0].lower, (Point{32, 5}));
  EXPECT_EQ(faces[0].upper, (Point{12, 15}));
  EXPECT_NEAR(faces[0].slope, std::atan(0.5), 1e-12);
  EXPECT_NEAR(faces[0].factor(), std::tan(20 * std::numbers::pi / 180) / 0.5, 1e-12);
  EXPECT_NE(describe(faces[0], {"m", 1}).find("rises at 26.6°, more than φ = 20.0° of 'sand'"), std::string::npos);
}

}  // namespace
}  // namespace talus::site
