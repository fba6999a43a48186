// SPDX-License-Identifier: MIT
// Sheet piles of case files in limit analysis, beside FEM and simple pressures.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "base/error.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "support/supported_slope.hpp"

namespace talus {
namespace {

/// A smooth sheet pile of `length` along a cut of 3 m in sand of 35°.
std::string write_sheet(double length, const std::string& more = "") {
  return fmt::format(R"(
title = "Sheet pile"
[geometry]
ground = [[0, 3], [12, 3], [12, 0], [24, 0]]
[[geometry.layer]]
name = "sand"
level = -9
[regions]
sand = "sand"
[materials.sand]
model = "mohr_coulomb"
unit_weight = 20
cohesion = 0.2
friction_angle = 35
tensile_strength = 0
young_modulus = "30 MPa"
poisson_ratio = 0.3
[[boundary]]
on = "bottom"
fix = "full"
[[boundary]]
on = "left"
fix = "normal"
[[boundary]]
on = "right"
fix = "normal"
[analysis]
methods = ["bounds"]
[bounds]
size = 1
[support.sheet]
kind = "wall"
line = [[12, 3], [12, {}]]
bond_friction = 0
{}
)",
                     3 - length, more);
}

bounds::BoundsResult search(const std::string& text, int triangles = 800) {
  bounds::BoundsOptions options;
  options.gap = 0.02;
  options.most_triangles = triangles;
  const site::Site site = support::read_site(text);
  return run::find_case_bounds(run::make_bounds_problem(site), options);
}

/// FEM has 1.294 and 1.303 on 1 and 0.5 m (ψ = φ). Rankine's pressures that change sides at one level need 1.245: a
/// wall finds more.
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
)"));
  EXPECT_GT(tied.lower, hinged.upper);
}

TEST(BoundsSheetPiles, WallOnAFixedSideIsRefused) {
  std::string text = write_sheet(6);
  const std::string from = "[[boundary]]\non = \"left\"", to = "[[boundary]]\non = \"face\"";
  text.replace(text.find(from), from.size(), to);
  text += "[[geometry.line]]\nname = \"face\"\npoints = [[12, 3], [12, 0]]\n";
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
