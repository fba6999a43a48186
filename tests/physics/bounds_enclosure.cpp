// SPDX-License-Identifier: MIT
// Strengths and pore pressures of limit analysis lie on the safe side of those of the case in all of each triangle.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "run/bounds/case_fields.hpp"
#include "run/bounds/kink_points.hpp"
#include "run/bounds/problem_of_case.hpp"
#include "support/scratch.hpp"
#include "support/supported_slope.hpp"

namespace talus {
namespace {

const std::string slope = R"([geometry]
ground = [[0, 6], [10, 6], [18, 10], [30, 10]]
layer = [{ name = "soil", level = 0 }]
line = [{ name = "face", points = [[10, 6], [18, 10]] }]
[regions]
soil = "soil"
[analysis]
methods = ["bounds"]
[bounds]
tension = "apex"
)";
const std::string clay = "[materials.soil]\nmodel = \"tresca\"\nunit_weight = 18\n";
const std::string sand =
    "[materials.soil]\nmodel = \"mohr_coulomb\"\nunit_weight = 18\ncohesion = 5\nfriction_angle = 30\n"
    "tensile_strength = 0\n";
const std::string shansep =
    "[materials.soil]\nmodel = \"shansep\"\nunit_weight = 18\nstrength_ratio = 0.25\nstrength_exponent = 0.8\n"
    "added_strength = 1\n";
const std::string rooted =
    "[materials.soil]\nmodel = \"rooted_mohr_coulomb\"\nunit_weight = 18\ncohesion = 3\nfriction_angle = 28\n"
    "tensile_strength = 0\n";

/// Strength and pressure of the problem are compared with the case at random points of each triangle and beside the
/// lines at which these bend, by which the enclosure itself is made only in part.
void expect_enclosed(const std::string& text) {
  const run::ProblemOfCase made = run::make_bounds_problem(support::read_site(text), run::Supports::below_soil);
  const std::vector<std::size_t> origins = made.fields->find_origins(made.problem);
  std::mt19937 random(7);
  const auto draw = [&] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
  std::vector<run::SoilPlace> places;
  std::vector<run::Weights> weights;
  for (std::size_t e = 0; e < made.problem.size(); ++e)
    for (int i = 0; i < 150; ++i) {
      const auto [first, second] = std::minmax({draw(), draw()});
      const run::Weights w{first, second - first, 1 - second};
      Vec<2> x{};
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t d = 0; d < 2; ++d)
          x[d] += w[c] * made.problem.nodes[static_cast<std::size_t>(made.problem.triangles[e][c])][d];
      places.push_back({origins[e], x});
      weights.push_back(w);
    }
  constexpr double tolerance = 0.1;  // [Pa], 1e-6 of the overburden
  const std::vector<double> pressures = made.fields->find_pressures(places);
  for (const bounds::Bound bound : {bounds::Bound::lower, bounds::Bound::upper}) {
    const bool is_lower = bound == bounds::Bound::lower;
    const bounds::Problem& problem = is_lower || !made.stronger ? made.problem : *made.stronger;
    const std::vector<double> cohesions = made.fields->find_cohesions(places, bound);
    double unsafe_strength = 0, unsafe_pressure = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::size_t e = i / 150;
      double strength = 0, pressure = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        strength += weights[i][c] * problem.strength[e][c].cohesion;
        pressure += weights[i][c] * problem.pore_pressure[e][c];
      }
      const double sign = is_lower ? 1 : -1;
      unsafe_strength = std::max(unsafe_strength, sign * (strength - cohesions[i]));
      unsafe_pressure = std::max(unsafe_pressure, sign * (pressures[i] - pressure));
    }
    EXPECT_LE(unsafe_strength, tolerance) << text;
    EXPECT_LE(unsafe_pressure, tolerance) << text;
  }
}

TEST(BoundsEnclosure, HoldsForStrengthsByLevelAndDepth) {
  expect_enclosed(slope + sand + "cohesion_gradient = 2\ncohesion_level = 7.03\n");
  expect_enclosed(slope + clay +
                  "profile_levels = [10, 6.52, 6.5, 6.4, 6.38, 0]\nprofile_strengths = [40, 40, 2, 2, 40, 40]\n");
  expect_enclosed(slope + clay + "profile_depths = [0, 1.03, 1.1, 4]\nprofile_strengths = [20, 30, 5, 60]\n");
  expect_enclosed(slope + clay + "profile_levels = [10, 5, 0]\nprofile_x = [4, 12.02, 12.05, 26]\n" +
                  "profile_strengths = [20, 30, 60, 40, 35, 70, 10, 35, 70, 40, 55, 90]\n");
}

TEST(BoundsEnclosure, HoldsForShansep) {
  const std::string load = "[[surcharge]]\nname = \"load\"\nx = [19.3, 20, 24.66, 24.7]\nload = [0, 20, 20, 0]\n";
  const std::string table = "[initial]\npore_pressure = \"water_table\"\nwater_table = [[0, 5], [14, 6.6], [30, 8]]\n";
  expect_enclosed(slope + load + shansep + "ocr = 1.4\n");
  expect_enclosed(slope + load + table + shansep + "profile_levels = [10, 4, 0]\nprofile_ocr = [4, 1.5, 1]\n");
  expect_enclosed(slope + load + table + shansep +
                  "profile_levels = [10, 5, 0]\nprofile_preconsolidation = [60, 100, 110]\n");
}

TEST(BoundsEnclosure, HoldsForRoots) {
  const std::string block = "[[roots]]\nground = \"face\"\ndepth = 1.2\ncohesion = 10\n";
  expect_enclosed(slope + block + rooted);
  expect_enclosed(slope + block + "profile = \"exponential\"\ndecay_depth = 0.4\n" + rooted);
  expect_enclosed(slope + block + "profile = \"table\"\ndepth_table = [[0, 1], [0.5, 0.9], [0.52, 0.2], [1.2, 0]]\n" +
                  "along = [[10, 1], [13, 0.5], [18, 1]]\n" + rooted);
}

TEST(BoundsEnclosure, HoldsForWaterTables) {
  const auto write = [](const std::string& line) {
    return slope + sand + "[initial]\npore_pressure = \"water_table\"\nwater_table = " + line + "\n";
  };
  expect_enclosed(write("[[0, 5], [14, 6.6], [30, 8.3]]"));
  expect_enclosed(write("[[0, 5], [13.99, 6], [14, 7], [14.01, 6], [30, 8.3]]"));
  expect_enclosed(write("[[0, 4], [17, 6.6], [17.001, 5], [30, 5.5]]"));
  expect_enclosed(
      slope + sand + "suction_strength = \"phi_b\"\nphi_b = 15\n" +
      "[initial]\npore_pressure = \"water_table\"\nlargest_suction = 12\nwater_table = [[0, 4], [30, 6]]\n");
}

TEST(BoundsEnclosure, HoldsForPressuresAtPoints) {
  const auto folder = support::make_scratch("bounds_enclosure");
  std::ofstream file(folder / "grid.csv");
  file << "x [m], y [m], pressure [kPa]\n";
  for (int i = 0; i <= 15; ++i)
    for (int j = 0; j <= 5; ++j)
      file << 2 * i << ", " << 2 * j << ", " << 10 * (6 - 2 * j) + 12 * std::sin(3 * i + 5 * j) << "\n";
  file.close();
  for (const std::string kind : {"linear", "thin_plate"})
    expect_enclosed(slope + sand + "[initial]\npore_pressure = \"grid\"\n[initial.pressure_grid]\nfile = \"" +
                    (folder / "grid.csv").string() + "\"\ninterpolation = \"" + kind + "\"\n");
}

TEST(BoundsEnclosure, HoldsForRatiosAtPoints) {
  const auto folder = support::make_scratch("bounds_enclosure");
  std::ofstream file(folder / "ratio.csv");
  file << "x [m], y [m], r_u\n";
  for (int i = 0; i <= 15; ++i)
    for (int j = 0; j <= 5; ++j) file << 2 * i << ", " << 2 * j << ", " << 0.3 + 0.2 * std::sin(3 * i + 5 * j) << "\n";
  file.close();
  expect_enclosed(slope + sand + "[initial]\npore_pressure = \"grid\"\n[initial.pressure_grid]\nfile = \"" +
                  (folder / "ratio.csv").string() + "\"\nquantity = \"r_u\"\n");
}

/// A triangle that a line halves has seven corners of parts; a corner of the triangle on the line belongs to both.
TEST(BoundsEnclosure, PartsHaveAPointInsideEachCorner) {
  const std::array<Vec<2>, 3> triangle{Vec<2>{0, 0}, Vec<2>{1, 0}, Vec<2>{0, 1}};
  EXPECT_EQ(run::KinkPoints({{{-1, 0.3}, {2, 0.3}}}).list(triangle).size(), 7U);
  EXPECT_EQ(run::KinkPoints({{{-1, -1}, {2, 2}}}).list(triangle).size(), 6U);
  EXPECT_EQ(run::KinkPoints({{{-1, 0.3}, {2, 0.3}}, {{0.2, -1}, {0.2, 2}}}).list(triangle).size(), 15U);
  EXPECT_TRUE(run::KinkPoints({{{-1, 2}, {2, 2}}}).list(triangle).empty());
  // Along a side there is one part.
  EXPECT_EQ(run::KinkPoints({{{-1, 0}, {2, 0}}}).list(triangle).size(), 3U);
}

}  // namespace
}  // namespace talus
