// SPDX-License-Identifier: MIT
// Interpolation of scattered values: linear functions are exact, and a spline passes through its points.
#include "mesh/scattered_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/error.hpp"
#include "support/draw.hpp"

namespace talus::mesh {
namespace {

std::vector<ScatteredValue> scatter(int count, auto&& function) {
  support::Draw draw(7);
  std::vector<ScatteredValue> values;
  for (int i = 0; i < count; ++i) {
    const std::array<double, 2> at{draw(100, 160), draw(-20, 10)};
    values.push_back({at, function(at)});
  }
  return values;
}

double plane(const std::array<double, 2>& x) {
  return 3 + 0.2 * x[0] - 0.7 * x[1];
}

TEST(ScatteredField, ReproducesPlanes) {
  for (const Scatter kind : {Scatter::linear, Scatter::thin_plate}) {
    const ScatteredField field(scatter(200, plane), kind);
    support::Draw draw(8);
    for (int i = 0; i < 500; ++i) {
      const std::array<double, 2> x{draw(105, 155), draw(-15, 5)};
      ASSERT_TRUE(field.covers(x));
      EXPECT_NEAR(field.find(x), plane(x), 1e-8);
    }
  }
}

TEST(ScatteredField, PassesThroughItsPoints) {
  const auto values = scatter(150, [](const auto& x) { return std::sin(x[0] / 7) * std::cos(x[1] / 5); });
  for (const Scatter kind : {Scatter::linear, Scatter::thin_plate}) {
    const ScatteredField field(values, kind);
    for (const ScatteredValue& v : values) EXPECT_NEAR(field.find(v.at), v.value, 1e-8);
  }
}

TEST(ScatteredField, SplineIsSmootherThanTriangles) {
  const auto function = [](const auto& x) { return std::sin(x[0] / 12) * std::cos(x[1] / 9); };
  const auto values = scatter(300, function);
  double error[2] = {0, 0};
  for (const Scatter kind : {Scatter::linear, Scatter::thin_plate}) {
    const ScatteredField field(values, kind);
    support::Draw draw(9);
    for (int i = 0; i < 500; ++i) {
      const std::array<double, 2> x{draw(110, 150), draw(-14, 4)};
      error[kind == Scatter::thin_plate] =
          std::max(error[kind == Scatter::thin_plate], std::abs(field.find(x) - function(x)));
    }
  }
  EXPECT_LT(error[1], 0.5 * error[0]);
}

TEST(ScatteredField, TakesRegularGrids) {
  // Four points on one circle.
  std::vector<ScatteredValue> values;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 10; ++j) values.push_back({{2.0 * i, 1.0 * j}, plane({2.0 * i, 1.0 * j})});
  const ScatteredField field(values, Scatter::linear);
  EXPECT_NEAR(field.find({7.3, 4.6}), plane({7.3, 4.6}), 1e-9);
  EXPECT_NEAR(field.find({0, 0}), plane({0, 0}), 1e-9);
}

/// The field of a mirrored, moved or turned grid is mirrored, moved or turned: no diagonal of a cell is preferred.
TEST(ScatteredField, OfAMirroredGridIsMirrored) {
  const auto bent = [](const std::array<double, 2>& x) { return std::max(-5.0, 49 + 0.6 * x[0] - 9.8 * x[1]); };
  const std::vector<std::function<std::array<double, 2>(const std::array<double, 2>&)>> ways{
      [](const auto& x) {
        return std::array{40.3 - x[0], x[1]};
      },
      [](const auto& x) {
        return std::array{x[0] + 441871.3, x[1] + 2500.7};
      },
      [](const auto& x) {
        return std::array{-x[1], x[0]};
      }};
  std::vector<ScatteredValue> values;
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 5; ++j) values.push_back({{4.9 * i, 2.1 * j}, bent({4.9 * i, 2.1 * j})});
  const ScatteredField field(values, Scatter::linear);
  for (const auto& way : ways) {
    std::vector<ScatteredValue> others = values;
    for (ScatteredValue& v : others) v.at = way(v.at);
    const ScatteredField other(others, Scatter::linear);
    support::Draw draw(11);
    for (int i = 0; i < 500; ++i) {
      const std::array<double, 2> x{draw(-10, 50), draw(-3, 14)};
      EXPECT_NEAR(other.find(way(x)), field.find(x), 1e-6) << x[0] << ' ' << x[1];
    }
  }
}

TEST(ScatteredField, KeepsTheNearestValueFarAway) {
  const ScatteredField field({{{0, 0}, 1}, {{10, 0}, 2}, {{10, 10}, 3}, {{0, 10}, 4}}, Scatter::linear);
  EXPECT_FALSE(field.covers({-5, 5}));
  EXPECT_NEAR(field.find({-1000, -1000}), 1, 1e-9);
  EXPECT_NEAR(field.find({1000, 1000}), 3, 1e-9);
  for (const double x : {-50.0, -5.0, 15.0, 60.0}) {
    EXPECT_GE(field.find({x, 5}), 1);
    EXPECT_LE(field.find({x, 5}), 4);
  }
}

TEST(ScatteredField, NamesItsFaults) {
  const auto expect = [](const std::vector<ScatteredValue>& values, Scatter kind, const std::string& part) {
    try {
      const ScatteredField field(values, kind);
      ADD_FAILURE() << part;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  expect({{{0, 0}, 1}, {{1, 0}, 1}}, Scatter::linear, "three are needed");
  expect({{{0, 0}, 1}, {{1, 1}, 1}, {{2, 2}, 1}, {{3, 3}, 1}}, Scatter::linear, "lie on one line");
  expect({{{0, 0}, 1}, {{1, 0}, 1}, {{0, 1}, 1}, {{1, 0}, 2}}, Scatter::linear, "points 2 and 4 lie at one place");
  expect(scatter(2001, plane), Scatter::thin_plate, "at most 2000");
}

}  // namespace
}  // namespace talus::mesh
