// SPDX-License-Identifier: MIT
// Consolidation of columns: the series of Terzaghi, Olson's ramp, layers of Schiffman and Stein, drains of Barron and
// Hansbo, and the orders of the method in space and time.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/consolidation_model.hpp"

namespace talus {
namespace {

using support::WetBox;

constexpr double oedometric = 1e7, conductivity = 1e-8, load = 100e3;
constexpr double c_v = conductivity * oedometric / support::water_weight;

/// u/u0 of a layer drained at its top, at the height z above its closed base, over its thickness (Terzaghi 1943).
double find_terzaghi(double z, double factor) {
  double sum = 0;
  for (int m = 0; m < 200; ++m) {
    const double a = std::numbers::pi / 2 * (2 * m + 1);
    sum += 2 / a * (m % 2 == 0 ? 1 : -1) * std::cos(a * z) * std::exp(-a * a * factor);
  }
  return sum;
}

/// The degree of consolidation of that layer.
double find_degree(double factor) {
  double sum = 0;
  for (int m = 0; m < 400; ++m) {
    const double a = std::numbers::pi / 2 * (2 * m + 1);
    sum += 2 / (a * a) * std::exp(-a * a * factor);
  }
  return 1 - sum;
}

/// The degree of consolidation under a load that grows linearly until T = `end` (Olson 1977).
double find_ramp_degree(double factor, double end) {
  double sum = 0;
  for (int m = 0; m < 400; ++m) {
    const double a = std::numbers::pi / 2 * (2 * m + 1), b = a * a;
    const double rest = std::exp(-b * factor);
    sum += 2 / (b * b) * (factor < end ? 1 - rest : std::exp(b * (end - factor)) - rest);
  }
  return factor < end ? factor / end * (1 - sum / factor) : 1 - sum / end;
}

fem::ConsolidationSchedule make_schedule(double end, std::vector<double> outputs = {}) {
  fem::ConsolidationSchedule schedule;
  schedule.duration = end;
  schedule.outputs = std::move(outputs);
  schedule.threads = 1;
  return schedule;
}

/// u over the load under such a load, while it grows.
double find_ramp_pressure(double z, double factor, double end) {
  double sum = 0;
  for (int m = 0; m < 200; ++m) {
    const double a = std::numbers::pi / 2 * (2 * m + 1);
    sum += 2 / (a * a * a * end) * (m % 2 == 0 ? 1 : -1) * std::cos(a * z) * (1 - std::exp(-a * a * factor));
  }
  return sum;
}

/// Largest error of the excess pressures of the column of Terzaghi against the series, over the load.
double find_column_error(const WetBox& box, const fem::ConsolidationState<2>& state, double factor) {
  double error = 0;
  for (std::size_t n = 0; n < box.mesh.nodes.size(); ++n)
    error = std::max(error, std::abs(box.find_excess(state, n) / load - find_terzaghi(box.mesh.nodes[n][1], factor)));
  return error;
}

class Consolidation : public testing::Test {
 protected:
  WetBox box_{{{1, oedometric, conductivity}}, 0.25, 0.1};
  void SetUp() override {
    box_.drain(1, 1, 1);
    box_.press_top(load);
  }
};

TEST_F(Consolidation, UndrainedLoadIsBorneByTheWater) {
  const auto state = box_.press_undrained(box_.make_start());
  for (std::size_t n = 0; n < box_.mesh.nodes.size(); ++n)
    EXPECT_NEAR(box_.find_excess(state, n), load, 1e-4 * load) << box_.mesh.nodes[n][1];
}

TEST_F(Consolidation, FollowsTerzaghi) {
  const std::vector<double> factors{0.05, 0.1, 0.2, 0.5, 1.0, 2.0};
  std::vector<double> times;
  for (const double f : factors) times.push_back(f / c_v);
  const auto start = box_.press_undrained(box_.make_start());
  const auto result = fem::run_stage(box_.model, start, make_schedule(times.back(), times));
  ASSERT_TRUE(result.converged);
  ASSERT_EQ(result.outputs.size(), factors.size());
  const std::size_t top = box_.find_node(0, 1);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const auto& at = result.outputs[i].at;
    EXPECT_LT(find_column_error(box_, at, factors[i]), 0.005) << factors[i];
    EXPECT_NEAR(-at.solid.displacement[top][1] * oedometric / load, find_degree(factors[i]), 0.003) << factors[i];
  }
  for (const auto& step : result.steps) EXPECT_LT(step.error, 2 * make_schedule(1).tolerance);
}

TEST_F(Consolidation, RampFollowsOlson) {
  // The stage brings the load over T = 0.5, a second one keeps it.
  const double end = 0.5;
  auto first = fem::run_stage(box_.model, box_.make_start(), make_schedule(end / c_v, {0.1 / c_v, 0.2 / c_v}));
  auto later = make_schedule(1.5 / c_v, {1.0 / c_v, 2.0 / c_v});
  later.start = end / c_v;
  const auto second = fem::run_stage(box_.model, first.outputs.back().at, later);
  ASSERT_TRUE(first.converged && second.converged);
  first.outputs.insert(first.outputs.end(), second.outputs.begin(), second.outputs.end());
  const std::vector<double> factors{0.1, 0.2, 0.5, 1.0, 2.0}, published{0.04758, 0.13454, 0.52467, 0.86439, 0.98850};
  ASSERT_EQ(first.outputs.size(), factors.size());
  const std::size_t top = box_.find_node(0, 1);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    EXPECT_NEAR(find_ramp_degree(factors[i], end), published[i], 1e-5);
    EXPECT_NEAR(-first.outputs[i].at.solid.displacement[top][1] * oedometric / load, find_ramp_degree(factors[i], end),
                0.003)
        << factors[i];
  }
}

TEST_F(Consolidation, ErrorsAreOfSecondOrderInTime) {
  // From a smooth state on, on one mesh, against steps that are sixteen times as short.
  const auto start = box_.press_undrained(box_.make_start());
  const auto smooth = fem::run_stage(box_.model, start, make_schedule(0.1 / c_v)).outputs.back().at;
  const auto march = [&](int steps) {
    auto schedule = make_schedule(0.4 / c_v);
    schedule.first_step = schedule.largest_step = schedule.duration / steps;
    schedule.tolerance = 1e9;
    return fem::run_stage(box_.model, smooth, schedule).outputs.back().at;
  };
  const auto reference = march(160);
  const auto find_error = [&](int steps) {
    const auto at = march(steps);
    double error = 0;
    for (std::size_t n = 0; n < at.head.size(); ++n) error = std::max(error, std::abs(at.head[n] - reference.head[n]));
    return error;
  };
  const double one = find_error(5), two = find_error(10), four = find_error(20);
  EXPECT_GT(std::log2(one / two), 1.8);
  EXPECT_GT(std::log2(two / four), 1.8);
}

TEST(ConsolidationColumns, ErrorsAreOfSecondOrderInSpace) {
  // Under a load that grows from 0: a load at once is no smooth start, and its errors fall with the power 1.5.
  const double end = 0.5;
  const auto find_error = [&](double size) {
    WetBox box({{1, oedometric, conductivity}}, size, size);
    box.drain(1, 1, 1);
    box.press_top(load);
    auto schedule = make_schedule(end / c_v);
    schedule.tolerance = 1e-5;
    const auto at = fem::run_stage(box.model, box.make_start(), schedule).outputs.back().at;
    double sum = 0;
    for (std::size_t n = 0; n < box.mesh.nodes.size(); ++n) {
      const double miss = box.find_excess(at, n) / load - find_ramp_pressure(box.mesh.nodes[n][1], end, end);
      sum += miss * miss / static_cast<double>(box.mesh.nodes.size());
    }
    return std::sqrt(sum);
  };
  const double coarse = find_error(0.1), fine = find_error(0.05), finest = find_error(0.025);
  EXPECT_GT(std::log2(coarse / fine), 1.6);
  EXPECT_GT(std::log2(fine / finest), 1.9);
}

TEST(ConsolidationColumns, LayersOfSchiffmanAndStein) {
  // Published example in feet, after the tests of the open program geotecha: m_v, c_v and k = c_v m_v from the top.
  const std::vector<double> thickness{10, 20, 30, 20}, c{0.0411, 0.1918, 0.0548, 0.0686},
      m{3.07e-3, 1.95e-3, 9.74e-4, 1.95e-3};
  std::vector<support::WetLayer> layers;
  for (std::size_t i = 4; i-- > 0;) layers.push_back({thickness[i], 1 / m[i], c[i] * m[i] * support::water_weight});
  WetBox box(layers, 2.5, 1.25);
  box.drain(1, 80, 80);
  box.drain(1, 0, 80);
  box.press_top(100);
  const std::vector<double> times{740, 2930, 7195}, mean{81.3788705, 56.39858151, 27.95321684},
      settlement{3.48058021, 6.98645472, 10.45107157};
  const std::vector<std::array<double, 4>> excess{{5, 48.6855554, 27.3864218, 13.4294382},
                                                  {10, 83.1401151, 51.7585907, 25.5491366},
                                                  {30, 98.1979376, 70.5880378, 35.4593221},
                                                  {60, 93.4796129, 55.8128098, 25.5970977}};
  const auto result =
      fem::run_stage(box.model, box.press_undrained(box.make_start()), make_schedule(times.back(), times));
  ASSERT_TRUE(result.converged);
  const std::size_t top = box.find_node(0, 80);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto& at = result.outputs[i].at;
    EXPECT_NEAR(box.find_mean_excess(at), mean[i], 0.5) << times[i];
    EXPECT_NEAR(-at.solid.displacement[top][1], settlement[i], 0.01 * settlement[i]) << times[i];
    for (const auto& row : excess)
      EXPECT_NEAR(box.find_excess(at, box.find_node(0, 80 - row[0])), row[i + 1], 1.0) << row[0] << " " << times[i];
  }
}

TEST(ConsolidationColumns, DrainsOfBarronAndHansbo) {
  // Equal strain without smear: U = 1 − exp(−8 T/F), F = n² ln n/(n² − 1) − (3n² − 1)/(4n²), T = c_h t/D_e².
  WetBox box({{1, oedometric, conductivity}}, 0.25, 0.25);
  box.press_top(load);
  const double n = 10, reach = 1.5;
  const double f = n * n / (n * n - 1) * std::log(n) - (3 * n * n - 1) / (4 * n * n);
  box.model.drains.assign(box.mesh.elements.size(), {8 * conductivity / (f * reach * reach), 1.0});
  const std::vector<double> factors{0.05, 0.1, 0.2, 0.5}, published{0.22387, 0.39762, 0.63713, 0.92068};
  std::vector<double> times;
  for (const double t : factors) times.push_back(t * reach * reach / c_v);
  const auto result =
      fem::run_stage(box.model, box.press_undrained(box.make_start()), make_schedule(times.back(), times));
  ASSERT_TRUE(result.converged);
  for (std::size_t i = 0; i < factors.size(); ++i)
    EXPECT_NEAR(1 - box.find_mean_excess(result.outputs[i].at) / load, published[i], 0.002) << factors[i];
}

}  // namespace
}  // namespace talus
