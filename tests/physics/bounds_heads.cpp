// SPDX-License-Identifier: MIT
// Heads of bars in limit analysis: each presses on a metre of the ground, whatever the size of the triangles.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "run/bounds/problem_of_case.hpp"
#include "support/supported_slope.hpp"

namespace talus {
namespace {

/// A cut of 6 m at 56°; `more`: layers and supports.
std::string write_cut(const std::string& more, const std::string& size = "") {
  return R"(
[geometry]
box = [[0, 0], [26, 11]]
[[geometry.polygon]]
name = "soil"
points = [[0, 0], [26, 0], [26, 4], [15, 4], [11, 10], [0, 10]]
[regions]
soil = "silt"
[materials.silt]
model = "mohr_coulomb"
unit_weight = 19
cohesion = 6
friction_angle = 28
dilatancy_angle = 28
tensile_strength = 0
young_modulus = "30 MPa"
poisson_ratio = 0.3
[analysis]
methods = ["bounds"]
[bounds]
)" + size +
         more;
}

std::string write_bars(const std::string& kind, const std::string& heads, const std::string& strength) {
  return "[support.bar]\nkind = \"" + kind + "\"\nheads = " + heads +
         "\ninclination = 15\nout_of_plane_spacing = 2\ntensile_strength = 500\nbond = 100\naxial_stiffness = 20000\n" +
         strength;
}

const std::string anchor = "length = 12\nbond_length = 5\nplate = 450\nprestress = 200\n",
                  nail = "length = 8\nplate = 200\n";

/// The loaded length of the ground of each head [m].
std::vector<double> list_head_widths(const std::string& text) {
  const bounds::Problem problem = run::make_bounds_problem(support::read_site(text), run::Supports::below_soil).problem;
  std::vector<double> widths;
  for (const bounds::BarHead& head : problem.heads) {
    double& width = widths.emplace_back();
    for (const auto& [from, to] : head.sides) {
      const Vec<2>&a = problem.nodes[static_cast<std::size_t>(from)], &b = problem.nodes[static_cast<std::size_t>(to)];
      width += std::hypot(b[0] - a[0], b[1] - a[1]);
    }
  }
  return widths;
}

TEST(BoundsHeads, PressOnAMetreOfTheGround) {
  const std::string shorter = "length = 9\nbond_length = 4\nplate = 450\nprestress = 200\n";
  const auto check = [](const std::string& bars, const char* size, std::size_t count) {
    const std::vector<double> widths = list_head_widths(write_cut(bars, size));
    EXPECT_EQ(widths.size(), count);
    for (const double width : widths) EXPECT_NEAR(width, 1, 0.02) << bars << size;
  };
  // In the middle of the face, beside crest and toe, and two heads closer than a metre.
  check(write_bars("anchor", "[[12.5, 7.75]]", shorter), "", 1);
  check(write_bars("anchor", "[[11.1, 9.85]]", shorter), "", 1);
  check(write_bars("nail", "[[14.9, 4.15]]", nail), "size = 0.7\n", 1);
  check(write_bars("nail", "[[12.5, 7.75], [12.9, 7.15]]", nail), "", 2);
}

/// Heads whose coordinates were rounded lie a little inside or outside the face.
TEST(BoundsHeads, LieOnTheGroundDespiteRounding) {
  for (const double off : {-5e-5, -5e-7, 5e-7, 5e-5}) {
    const double along = off / std::sqrt(52.0);  // the outward normal of the face is (6, 4)
    const std::vector<double> widths = list_head_widths(
        write_cut(write_bars("nail", fmt::format("[[{:.9f}, {:.9f}]]", 13 + 6 * along, 7 + 4 * along), nail)));
    ASSERT_EQ(widths.size(), 1u) << off;
    EXPECT_NEAR(widths[0], 1, 0.02) << off;
  }
}

/// A layer that meets the ground at the head, and a line of the water table 0.3 m above it.
TEST(BoundsHeads, PressOnAMetreOfTheGroundBesideOtherLinesOfTheMesh) {
  std::string text = write_cut(write_bars("nail", "[[12.5, 7.75]]", nail));
  const std::string one = "points = [[0, 0], [26, 0], [26, 4], [15, 4], [11, 10], [0, 10]]";
  text.replace(text.find(one), one.size(), R"(points = [[0, 0], [26, 0], [26, 4], [15, 4], [12.5, 7.75], [0, 7.75]]
[[geometry.polygon]]
name = "upper"
points = [[0, 7.75], [12.5, 7.75], [11, 10], [0, 10]])");
  text.replace(text.find("soil = \"silt\""), 13, "soil = \"silt\"\nupper = \"silt\"");
  text += "[initial]\npore_pressure = \"water_table\"\nwater_table = [[0, 8.1], [12.27, 8.1], [15, 4], [26, 4]]\n";
  const std::vector<double> widths = list_head_widths(text);
  ASSERT_EQ(widths.size(), 1u);
  EXPECT_NEAR(widths[0], 1, 0.02);
}

/// The force of a horizontal bar at x; 0 beside it [N/m].
double find_bar_force(const bounds::Problem& problem, double x) {
  for (const bounds::BarEdge& bar : problem.bars) {
    const double from = problem.nodes[static_cast<std::size_t>(bar.from)][0],
                 part = (x - from) / (problem.nodes[static_cast<std::size_t>(bar.to)][0] - from);
    if (part >= 0 && part <= 1) return bar.force[0] + part * (bar.force[1] - bar.force[0]);
  }
  return 0;
}

/// Bond by friction grows with the depth below the face, so that the force is a curve: a line between two nodes above
/// it proves nothing. What a coarse mesh holds for the lower bound lies below what a fine one holds for the upper, and
/// conversely.
TEST(BoundsHeads, ForcesOfBarsAreOnTheSafeSideBetweenTheirNodes) {
  const std::string grid =
      "[support.bar]\nkind = \"geosynthetic\"\nheads = [[13.666667, 6]]\nends = [[5, 6]]\nstrength = 60\n"
      "connection = 5\nbond_friction = 26\nbond_scale = 0.8\nbond_adhesion = 1\n";
  const auto make = [&](const std::string& size) {
    return run::make_bounds_problem(support::read_site(write_cut(grid, size)), run::Supports::below_soil);
  };
  const run::ProblemOfCase coarse = make("size = 4\n"), fine = make("size = 0.3\n");
  ASSERT_TRUE(coarse.stronger && fine.stronger);
  double widest = 0, largest = 0;
  for (double x = 5.05; x < 13.65; x += 0.05) {
    const double low = find_bar_force(coarse.problem, x), high = find_bar_force(*coarse.stronger, x);
    EXPECT_LE(low, find_bar_force(*fine.stronger, x) * (1 + 1e-6)) << x;
    EXPECT_GE(high * (1 + 1e-6), find_bar_force(fine.problem, x)) << x;
    widest = std::max(widest, find_bar_force(*fine.stronger, x) - find_bar_force(fine.problem, x));
    largest = std::max(largest, high);
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(widest, 0.1 * largest) << "they meet on finer meshes";
}

TEST(BoundsHeads, OfOneAnchoredCutGiveIntervalsThatOverlap) {
  std::vector<std::array<double, 2>> intervals;
  for (const char* size : {"", "size = 1\n"}) {
    bounds::BoundsOptions options;
    options.gap = 0.15, options.most_triangles = 600;
    const site::Site site = support::read_site(write_cut(write_bars("anchor", "[[12.5, 7.75]]", anchor), size));
    const auto found = run::find_case_bounds(run::make_bounds_problem(site, run::Supports::below_soil), options);
    EXPECT_EQ(found.no_lower + found.no_upper, "");
    intervals.push_back({found.lower, found.upper});
  }
  for (const auto& a : intervals)
    for (const auto& b : intervals) EXPECT_LE(a[0], b[1]);
  // FEM has 1.120 [0.976, 1.191].
  EXPECT_LT(intervals[0][0], 1.191);
}

/// A slab of strong soil on a thin seam of clay along a plane at θ, held by nails without heads that dip by 15°.
struct Slab {
  static constexpr double cohesion = 15, length = 8.94427191, weight = 20 * 9.6 + 0.1 * 3.2;  // kPa, m, kN/m

  static std::string write(const std::string& heads, double force, const char* sense) {
    return fmt::format(R"(
[geometry]
box = [[2, 0], [16, 8]]
[[geometry.polygon]]
name = "base"
points = [[2, 0], [16, 0], [16, 8], [12, 6], [4, 2], [2, 2]]
[[geometry.polygon]]
name = "seam"
points = [[4, 2], [12, 6], [12, 6.4], [4, 2.4]]
[[geometry.polygon]]
name = "slab"
points = [[4, 2.4], [12, 6.4], [12, 7.6], [4, 3.6]]
[regions]
base = "rock"
seam = "clay"
slab = "rock"
[materials.rock]
model = "mohr_coulomb"
unit_weight = 20
cohesion = 1e5
friction_angle = 0
tensile_strength = 1e5
[materials.clay]
model = "mohr_coulomb"
unit_weight = 0.1
cohesion = {}
friction_angle = 0
tensile_strength = 0
[analysis]
methods = ["bounds"]
[bounds]
size = 3
tension = "apex"
[support.bar]
kind = "nail"
heads = {}
inclination = 15
length = 8
out_of_plane_spacing = 1
tensile_strength = {}
plate = 0
bond = 1000
sense = "{}"
)",
                       cohesion, heads, force, sense);
  }
  /// F (W sin θ − T cos(θ + δ)) = c l for active bars, and F W sin θ = c l + T cos(θ + δ) for passive ones.
  static double find_factor(double force, bool is_active) {
    const double theta = std::atan(0.5), held = force * std::cos(theta + std::atan(1.0) / 3),
                 driving = weight * std::sin(theta), resisting = cohesion * length;
    return is_active ? resisting / (driving - held) : (resisting + held) / driving;
  }
};

/// The ends of the seam, where its shear stress vanishes, take 0.2 % of the factor.
void expect_slab(const std::string& heads, double force, int count) {
  for (const bool is_active : {true, false}) {
    bounds::BoundsOptions options;
    options.gap = 0.2, options.most_triangles = 250;
    const double exact = Slab::find_factor(count * force, is_active);
    options.start = exact;
    const site::Site site = support::read_site(Slab::write(heads, force, is_active ? "active" : "passive"));
    const auto found = run::find_case_bounds(run::make_bounds_problem(site, run::Supports::below_soil), options);
    EXPECT_EQ(found.no_lower + found.no_upper, "");
    EXPECT_LE(found.lower, exact * (1 + 1e-6)) << is_active;
    EXPECT_GE(found.upper, 0.995 * exact) << is_active;
    EXPECT_LE(found.upper, 1.06 * exact) << is_active;
    EXPECT_GE(found.lower, 0.8 * exact) << is_active;
  }
}

TEST(BoundsBars, HoldASlabOnAPlaneByTheConventionOfLem) {
  expect_slab("[[7, 5.1]]", 20, 1);
}

TEST(BoundsBars, OfARowHoldASlabTogether) {
  expect_slab("[[6, 4.6], [7, 5.1], [8, 5.6]]", 7, 3);
}

}  // namespace
}  // namespace talus
