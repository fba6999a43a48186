// SPDX-License-Identifier: MIT
// Sheet piles of case files in limit analysis, beside FEM and simple pressures.

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "support/supported_slope.hpp"

namespace talus {
namespace {

using support::write_sheet;

bounds::BoundsResult search(const std::string& text, int triangles = 800) {
  bounds::BoundsOptions options;
  options.gap = 0.02;
  options.most_triangles = triangles;
  const site::Site site = support::read_site(text + "[bounds]\nsize = 1\n");
  return run::find_case_bounds(run::make_bounds_problem(site), options);
}

/// FEM has 1.323 and 1.309 on 1 and 0.5 m, 1.294 at size zero (ψ = φ). Rankine's pressures that change sides at one
/// level need 1.245: a wall finds more.
TEST(BoundsSheetPiles, CantileverIsStrongerThanPressuresThatChangeSides) {
  const auto found = search(write_sheet(6), 2600);
  EXPECT_GT(found.lower, 1.25);
  EXPECT_LT(found.lower, 1.294);
  EXPECT_GT(found.upper, 1.294);
  EXPECT_LT(found.upper, 1.33);
}

TEST(BoundsSheetPiles, HingesStrutsAndAnchorsCount) {
  const auto bare = search(write_sheet(8));
  const auto hinged = search(write_sheet(8, "plastic_moment = 40\n"));
  EXPECT_LT(hinged.upper, bare.lower);
  const auto braced = search(
      write_sheet(8, "plastic_moment = 40\nstrut_levels = [2.5]\nstrut_stiffness = 2e4\nstrut_strength = 100\n"));
  EXPECT_GT(braced.lower, hinged.upper);
  const auto tied = search(write_sheet(8, R"(plastic_moment = 40
[support.tie]
kind = "anchor"
heads = [[12, 2.5]]
inclination = 0
length = 11
bond_length = 4
out_of_plane_spacing = 2
tensile_strength = 200
plate = 200
bond = 60
axial_stiffness = 1e5
)"));
  EXPECT_GT(tied.lower, hinged.upper);
}

TEST(BoundsSheetPiles, WallOnAFixedSideIsRefused) {
  const std::string text = write_sheet(6) + R"(
[[geometry.line]]
name = "face"
points = [[12, 3], [12, 0]]
[[boundary]]
on = "bottom"
fix = "full"
[[boundary]]
on = "face"
fix = "normal"
)";
  const site::Site site = support::read_site(text);
  try {
    run::make_bounds_problem(site);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("a wall lies on a fixed side"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace talus
