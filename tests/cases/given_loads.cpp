// SPDX-License-Identifier: MIT
// Loads of limit analysis against those of the case: each side of the ground carries its loads, and a problem with
// another load is rejected.

#include "run/bounds/problem_of_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "cases/methods_slope.hpp"

namespace talus {
namespace {

struct Load {
  double from = 0, to = 0, first = 0, last = 0;  ///< x [m], and the load at both [Pa]
  double level = 0;                              ///< of the water [m]

  double find(double x) const { return x > from && x < to ? first + (last - first) * (x - from) / (to - from) : 0; }
};

input::Case make_case(const Load& load) {
  const std::string text = write_case(
      "\"bounds\"", fmt::format("[[surcharge]]\nname = \"shed\"\nx = [{}, {}]\nload = [\"{} Pa\", \"{} Pa\"]\n"
                                "[initial]\npore_pressure = \"water_table\"\nwater_table = [[0, {}], [44, {}]]\n",
                                load.from, load.to, load.first, load.last, load.level, load.level));
  return input::read_case_text(text, "slope.toml", {}).data;
}

/// Force and moment about the origin of the load on a side of the ground, by midpoints of many parts.
std::array<double, 3> sum_load(const Load& load, double weight, const Vec<2>& a, const Vec<2>& b) {
  constexpr int parts = 400;
  std::array<double, 3> sum{};
  for (int i = 0; i < parts; ++i) {
    const double s = (i + 0.5) / parts, x = a[0] + s * (b[0] - a[0]), y = a[1] + s * (b[1] - a[1]);
    const double dx = (b[0] - a[0]) / parts, dy = (b[1] - a[1]) / parts, p = weight * std::max(0.0, load.level - y);
    const double fx = p * dy, fy = -(p + load.find(x)) * dx;
    sum[0] += fx, sum[1] += fy, sum[2] += x * fy - y * fx;
  }
  return sum;
}

/// The same of a traction that is linear along the side.
std::array<double, 3> sum_traction(const bounds::Side& side, const Vec<2>& a, const Vec<2>& b) {
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  std::array<double, 3> sum{};
  for (const double s : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {  // Gauss
    std::array<double, 2> f{}, x{};
    for (std::size_t d = 0; d < 2; ++d) {
      f[d] = 0.5 * length * ((1 - s) * side.traction[0][d] + s * side.traction[1][d]);
      x[d] = (1 - s) * a[d] + s * b[d];
    }
    sum[0] += f[0], sum[1] += f[1], sum[2] += x[0] * f[1] - x[1] * f[0];
  }
  return sum;
}

TEST(GivenLoads, EachSideOfTheGroundCarriesItsLoads) {
  std::mt19937 random(7);
  const auto draw = [&](double from, double to) {
    return from + (to - from) * (static_cast<double>(random()) / 0x1p32);
  };
  for (int i = 0; i < 12; ++i) {
    Load load{draw(0.5, 20), 0, draw(5e3, 60e3), draw(5e3, 60e3), draw(4, 15.5)};
    load.to = load.from + draw(1, 20);
    const input::Case data = make_case(load);
    const double weight = data.water.density * data.gravity.acceleration;
    const bounds::Problem problem = run::make_bounds_problem(data).problem;
    double bears = 0;
    for (const bounds::Side& side : problem.sides) {
      if (side.holds_normal || side.holds_along) continue;
      const Vec<2>&from = problem.nodes[static_cast<std::size_t>(side.from)],
            &to = problem.nodes[static_cast<std::size_t>(side.to)];
      const auto got = sum_traction(side, from, to),
                 given = from[0] < to[0] ? sum_load(load, weight, from, to) : sum_load(load, weight, to, from);
      const double most = 1e-7 * (60e3 + 15 * weight) * std::hypot(to[0] - from[0], to[1] - from[1]);
      EXPECT_NEAR(got[0], given[0], most) << load.from << " " << load.to << " " << load.level;
      EXPECT_NEAR(got[1], given[1], most) << load.from << " " << load.to << " " << load.level;
      EXPECT_NEAR(got[2], given[2], 44 * most) << load.from << " " << load.to << " " << load.level;
      EXPECT_LE(got[1], most) << "no side is pulled up";
      bears += got[1];
    }
    const double shed = 0.5 * (load.first + load.last) * (load.to - load.from);
    EXPECT_LE(bears, -shed * (1 - 1e-9)) << "the shed, and the water";
  }
}

TEST(GivenLoads, AnotherLoadThanThatOfTheCaseIsRejected) {
  const Load load{3.3, 8.1, 20e3, 5e3, 2};
  const input::Case data = make_case(load);
  const auto judge = [&](double from, double to, double first, double last) {
    // The soil is on the left of the way: the ground runs to smaller x.
    return run::find_wrong_load(
        data,
        {{{from, 15}, {0, 15}, {}}, {{to, 15}, {from, 15}, {{{0, -last}, {0, -first}}}}, {{12, 15}, {to, 15}, {}}});
  };
  EXPECT_EQ(judge(3.3, 8.1, 20e3, 5e3), std::nullopt);
  EXPECT_NE(judge(3.3, 8.1, 20.1e3, 5e3), std::nullopt) << "half a per cent more";
  EXPECT_NE(judge(3.3, 8.3, 20e3, 5e3), std::nullopt) << "20 cm wider";
  EXPECT_NE(judge(3.3, 8.1, 5e3, 20e3), std::nullopt) << "mirrored";
  const auto wrong = judge(3.3, 8.1, 0, 0);
  ASSERT_TRUE(wrong.has_value());
  EXPECT_NE(wrong->find("nothing is proven"), std::string::npos) << *wrong;
}

/// Its rounding was the largest load there is, and nothing was proven.
TEST(GivenLoads, AWaterTableAlongTheGroundIsNoLoad) {
  const input::Case data =
      input::read_case_text(
          write_case(
              "\"bounds\"",
              "[initial]\npore_pressure = \"water_table\"\nwater_table = [[0, 15], [12, 15], [32, 5], [44, 5]]\n"),
          "slope.toml", {})
          .data;
  EXPECT_GT(run::make_bounds_problem(data).problem.size(), 0u);
  const std::vector<run::LoadedSide> rounded{{{32, 5}, {12, 15}, {{{1e-12, 2e-12}, {0, 0}}}}};
  EXPECT_EQ(run::find_wrong_load(data, rounded), std::nullopt);
}

}  // namespace
}  // namespace talus
