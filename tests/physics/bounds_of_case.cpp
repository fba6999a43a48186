// SPDX-License-Identifier: MIT
// Bounds that hold for the strengths and pore pressures of the case, and not only for those of its first mesh.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "run/bounds/case_fields.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "support/supported_slope.hpp"

namespace talus {
namespace {

struct ProvenInterval {
  double lower = 0, upper = 0;
};

/// Returns the interval under the assumptions of LEM.
ProvenInterval prove(const std::string& text, int triangles = 800, double gap = 0.03) {
  bounds::BoundsOptions options;
  options.gap = gap;
  options.most_triangles = triangles;
  const site::Site site = support::read_site(text);
  const auto found = run::find_case_bounds(run::make_bounds_problem(site, run::Supports::below_soil), options);
  EXPECT_EQ(found.no_lower + found.no_upper, "");
  return {found.lower, found.upper};
}

void expect_overlap(const ProvenInterval& a, const ProvenInterval& b) {
  EXPECT_LE(a.lower, b.upper);
  EXPECT_LE(b.lower, a.upper);
}

const std::string methods_and_bounds = "[analysis]\nmethods = [\"bounds\"]\n[bounds]\ntension = \"apex\"\n";

/// An embankment of 3 m on 20 m of clay, s_u 9 kPa down to 1 m and 2 kPa/m more below.
std::string write_embankment(const std::string& strength) {
  return R"(
[geometry]
ground = [[0, 20], [24, 20], [31.5, 23], [50, 23]]
[[geometry.layer]]
name = "fill"
level = 20
[[geometry.layer]]
name = "clay"
level = 0
[regions]
fill = "fill"
clay = "clay"
[materials.fill]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 2
friction_angle = 32
dilatancy_angle = 32
tensile_strength = 3.2
young_modulus = "50 MPa"
poisson_ratio = 0.3
[materials.clay]
model = "tresca"
unit_weight = 16
young_modulus = "5 MPa"
poisson_ratio = 0.45
)" + strength +
         methods_and_bounds;
}

/// An independent limit analysis on a mesh with a line at the kink has 1.171 to 1.189; Bishop 1.164, Spencer 1.151.
TEST(BoundsOfCase, HoldWhereStrengthGrowsBelowALevel) {
  const ProvenInterval gradient =
      prove(write_embankment("undrained_strength = 9\nundrained_gradient = 2\nundrained_level = 19\n"));
  EXPECT_LE(gradient.lower, 1.189);
  EXPECT_GE(gradient.lower, 1.15);
  EXPECT_GE(gradient.upper, 1.171);
  EXPECT_LE(gradient.upper, 1.23);
  expect_overlap(gradient, prove(write_embankment("profile_levels = [19, 0]\nprofile_strengths = [9, 47]\n")));
}

/// A cut of 6 m in clay whose strength grows below the toe: the same with a mesh of its own for each size.
TEST(BoundsOfCase, HoldForACutInClayThatIsStrongerBelowTheToe) {
  const std::string text = R"(
[geometry]
ground = [[0, 12], [14, 12], [20, 18], [36, 18]]
[[geometry.layer]]
name = "clay"
level = 0
[regions]
clay = "clay"
[materials.clay]
model = "mohr_coulomb"
unit_weight = 18
cohesion = 18
cohesion_gradient = 6
cohesion_level = 10.7
friction_angle = 0
dilatancy_angle = 0
tensile_strength = 0
young_modulus = "5 MPa"
poisson_ratio = 0.45
)" + methods_and_bounds;
  const ProvenInterval own = prove(text, 500), fine = prove(text + "size = 1\n", 600);
  expect_overlap(own, fine);
  EXPECT_LT(own.upper / own.lower, 1.1);
  EXPECT_LT(fine.upper / fine.lower, 1.1);
}

const std::string wet_slope = R"(
[geometry]
ground = [[0, 30], [16, 30], [32, 38], [60, 38]]
[[geometry.layer]]
name = "a"
level = 0
[regions]
a = "a"
[materials.a]
model = "mohr_coulomb"
unit_weight = 19
saturated_unit_weight = 20
cohesion = 2
friction_angle = 32
dilatancy_angle = 32
tensile_strength = 3.2
young_modulus = "50 MPa"
poisson_ratio = 0.3
[initial]
pore_pressure = "water_table"
water_table = [[0, 30], [16, 30], [30, 34.5], [60, 35.5]]
)" + methods_and_bounds;

/// An independent limit analysis on a mesh with a line along the water table has 1.217 to 1.244; Spencer 1.246.
TEST(BoundsOfCase, HoldWhereAWaterTableCrossesTriangles) {
  const ProvenInterval found = prove(wet_slope, 900);
  EXPECT_LE(found.lower, 1.244);
  EXPECT_GE(found.lower, 1.15);
  EXPECT_GE(found.upper, 1.246);
}

/// Fields of a section with other strengths or pressures prove nothing about the case.
TEST(BoundsOfCase, AreWithdrawnWhereTheFieldsAreNotThoseOfTheCase) {
  bounds::BoundsOptions options;
  options.gap = 0.5;
  options.most_triangles = 100;
  const auto stronger =
      support::read_site(write_embankment("undrained_strength = 9\nundrained_gradient = 2\nundrained_level = 19\n"));
  run::ProblemOfCase made = run::make_bounds_problem(stronger, run::Supports::below_soil);
  for (auto& corners : made.problem.strength)
    for (bounds::Strength& soil : corners)
      if (soil.tan_friction == 0) soil.cohesion *= 1.2;
  bounds::BoundsResult found = bounds::find_bounds(made.problem, options);
  const double was = found.lower;
  EXPECT_GT(was, 0);
  run::hold_to_case(*made.fields, found);
  EXPECT_EQ(found.lower, 0);
  EXPECT_NE(found.no_lower.find("the strength changes inside the triangles"), std::string::npos);

  run::ProblemOfCase wet = run::make_bounds_problem(support::read_site(wet_slope), run::Supports::below_soil);
  for (auto& pressure : wet.problem.pore_pressure)
    for (double& p : pressure) p *= 1.5;
  found = bounds::find_bounds(wet.problem, options);
  ASSERT_TRUE(std::isfinite(found.upper));
  run::hold_to_case(*wet.fields, found);
  EXPECT_FALSE(std::isfinite(found.upper));
  EXPECT_NE(found.no_upper.find("the pore pressure changes inside the triangles"), std::string::npos);
}

/// Without water and with uniform strength nothing is evaluated between the corners.
/// A slope of 4 m at 1 in 2; `more`: its soil and what acts on it.
std::string write_jump(const std::string& more) {
  return "[geometry]\nground = [[0, 6], [10, 6], [18, 10], [30, 10]]\nlayer = [{ name = \"soil\", level = 0 }]\n"
         "line = [{ name = \"face\", points = [[10, 6], [18, 10]] }]\n[regions]\nsoil = \"soil\"\n" +
         methods_and_bounds + more;
}

/// Expects that no triangle of the first mesh has corners on both sides of a line, by their distances from it.
void expect_cut(const std::string& text, const std::function<double(const Vec<2>&)>& find_distance) {
  const bounds::Problem problem = run::make_bounds_problem(support::read_site(text), run::Supports::below_soil).problem;
  for (const bounds::Triangle& t : problem.triangles) {
    double least = 0, most = 0;
    for (const int node : t) {
      const double off = find_distance(problem.nodes[static_cast<std::size_t>(node)]);
      least = std::min(least, off), most = std::max(most, off);
    }
    EXPECT_LT(std::min(-least, most), 1e-6);
  }
}

/// The undrained strength jumps below the end of a load, and the cohesion of roots at their depth: no points inside a
/// triangle would find a sliver of weaker soil.
TEST(BoundsOfCase, TrianglesEndWhereStrengthJumps) {
  expect_cut(write_jump("[[surcharge]]\nname = \"load\"\nx = [19.3, 24.7]\nload = [20000, 20000]\n[materials.soil]\n"
                        "model = \"shansep\"\nunit_weight = 18\nstrength_ratio = 0.25\nstrength_exponent = 0.8\n"
                        "added_strength = 10\nprofile_levels = [10, 0]\nprofile_preconsolidation = [100, 200]\n"),
             [](const Vec<2>& x) { return x[0] - 24.7; });
  const auto find_depth = [](const Vec<2>& x) {
    const double along = ((x[0] - 10) * 2 + (x[1] - 6)) / std::sqrt(5.0),
                 across = ((x[0] - 10) - 2 * (x[1] - 6)) / std::sqrt(5.0);
    return along > 0 && along < std::sqrt(80.0) ? across - 1.2 : 0;
  };
  expect_cut(write_jump("[[roots]]\nground = \"face\"\ndepth = 1.2\ncohesion = 10\n[materials.soil]\n"
                        "model = \"rooted_mohr_coulomb\"\nunit_weight = 18\ncohesion = 3\nfriction_angle = 28\n"
                        "tensile_strength = 0\n"),
             find_depth);
}

/// Still water above all of the ground takes its weight from the soil and changes nothing else: a submerged slope has
/// the interval of the dry one with the buoyant unit weight, where its strength bends too.
TEST(BoundsOfCase, OfASubmergedSlopeAreThoseOfTheBuoyantWeight) {
  const auto write = [](const std::string& weight, const std::string& water) {
    return write_jump(
        "size = 2\n[materials.soil]\nmodel = \"mohr_coulomb\"\n" + weight +
        "cohesion = 4\ncohesion_gradient = 1.5\ncohesion_level = 7.3\nfriction_angle = 20\ndilatancy_angle = 20\n"
        "tensile_strength = 3\nyoung_modulus = \"50 MPa\"\npoisson_ratio = 0.3\n" +
        water);
  };
  const ProvenInterval dry = prove(write("unit_weight = 10.19\n", ""), 300, 0.1),
                       wet = prove(write("unit_weight = 19\nsaturated_unit_weight = 20\n",
                                         "[initial]\npore_pressure = \"water_table\"\n"
                                         "water_table = [[0, 14], [30, 14]]\n"),
                                   300, 0.1);
  EXPECT_NEAR(wet.lower, dry.lower, 1e-7 * dry.lower);
  EXPECT_NEAR(wet.upper, dry.upper, 1e-7 * dry.upper);
}

/// 'bottom' is the lowest level of the section, on which an inclined base does not lie.
TEST(BoundsOfCase, NameABaseThatNothingFixes) {
  const auto write = [](const std::string& base, const std::string& more) {
    return "[geometry]\npolygon = [{ name = \"soil\", points = [" + base +
           ", [30, 10], [18, 10], [10, 6], [0, 6]] }]\n"
           "line = [{ name = \"base\", points = [" +
           base + "] }]\n[regions]\nsoil = \"soil\"\n" + methods_and_bounds +
           "[materials.soil]\nmodel = \"tresca\"\nunit_weight = 18\nundrained_strength = 30\n" + more;
  };
  const auto list_notes = [](const std::string& text) {
    return run::make_bounds_problem(support::read_site(text)).notes;
  };
  ASSERT_EQ(list_notes(write("[0, -1], [30, 2]", "")).size(), 1u);
  EXPECT_NE(list_notes(write("[0, -1], [30, 2]", "")).front().find("no [[boundary]] fixes the base"),
            std::string::npos);
  EXPECT_TRUE(list_notes(write("[0, -1], [30, 2]", "[[boundary]]\non = \"base\"\nfix = \"full\"\n")).empty());
  EXPECT_TRUE(list_notes(write("[0, 0], [30, 0]", "")).empty());
}

TEST(BoundsOfCase, OfUniformDrySoilNeedNoSecondProblem) {
  const std::string dry = wet_slope.substr(0, wet_slope.find("[initial]")) + methods_and_bounds;
  const auto made = run::make_bounds_problem(support::read_site(dry), run::Supports::below_soil);
  EXPECT_FALSE(made.stronger);
  EXPECT_EQ(made.enclosure, nullptr);
}

}  // namespace
}  // namespace talus
