// SPDX-License-Identifier: MIT
// Transpiration as a sink in seepage: drying columns against sums and an ordinary differential equation, water budgets
// of seasons, and mesh dependence.

#include <gtest/gtest.h>

#include <numeric>

#include "physics/seepage_box.hpp"

namespace talus {
namespace {

using namespace support;

constexpr double hour = 3600, day = 24 * hour;

/// Roots spread evenly from `bottom` up: W = ∫ N dV over the area there, times the width of the ground.
template <int D>
fem::RootSink make_sink(const mesh::Mesh<D>& mesh, double ground, double rate, const std::array<double, 4>& suctions,
                        double bottom = -1) {
  fem::RootSink sink{"grass", {suctions}, {{0.0}, {rate}}, std::vector<double>(mesh.nodes.size(), 0.0)};
  double sum = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    double middle = 0;
    for (int i : mesh.elements[e]) middle += mesh.nodes[static_cast<std::size_t>(i)][1] / (D + 1);
    if (middle < bottom) continue;
    for (int i : mesh.elements[e]) sink.weights[static_cast<std::size_t>(i)] += mesh.volumes[e] / (D + 1);
    sum += mesh.volumes[e];
  }
  for (double& w : sink.weights) w *= ground / sum;
  return sink;
}

HydraulicSoil<2> make_loam(double conductivity = 1e-7) {
  auto soil = make_soil<2>(conductivity, 0.4);
  soil.retention = material::VanGenuchten{0.1, 1, 10e3, 0.35};
  soil.relative = material::Mualem::with_air_entry(0.35, material::SaturationMeasure::effective, soil.retention, 500);
  return soil;
}

template <int D>
std::vector<double> make_still_heads(const mesh::Mesh<D>& mesh, double level) {
  return std::vector<double>(mesh.nodes.size(), level);
}

TEST(SeasonColumn, UnreducedUptakeIsLinearInTimeIn2DAnd3D) {
  const auto look = [](const auto& mesh, const auto& soil, double ground) {
    constexpr int D = static_cast<int>(std::tuple_size_v<std::decay_t<decltype(mesh.nodes[0])>>);
    const double rate = 5e-3 / day;
    SeepageModel<D> model{&mesh, {soil}, {}};
    model.sinks = {make_sink<D>(mesh, ground, rate, {0, 0, 1e8, 2e8}, 0.5)};
    fem::SeepageSchedule schedule;
    for (int i = 1; i <= 5; ++i) schedule.outputs.push_back(2 * i * day);
    schedule.head_tolerance = 0.01;
    const auto heads = make_still_heads<D>(mesh, -1);
    const auto history = fem::solve_transient_seepage<D>(model, heads, schedule);
    for (std::size_t i = 0; i < history.states.size(); ++i) {
      const double exact = rate * ground * schedule.outputs[i];
      EXPECT_NEAR(history.uptakes[i][0].actual, exact, 1e-12 * exact);
      EXPECT_NEAR(history.uptakes[i][0].potential, exact, 1e-12 * exact);
      EXPECT_NEAR(-history.stored[i], exact, 1e-9 * exact);
      EXPECT_LT(std::abs(history.states[i].balance_error), 1e-9 * rate * ground);
    }
    const double before = fem::find_stored_water<D>(model, heads);
    EXPECT_NEAR(fem::find_stored_water<D>(model, history.states.back().head) - before, history.stored.back(),
                1e-12 * before);
  };
  look(make_soil_box<2>({2, 10}, {0.2, 1.0}), make_loam(), 0.2);
  auto soil = make_soil<3>(1e-7, 0.4);
  soil.retention = material::VanGenuchten{0.1, 1, 10e3, 0.35};
  look(make_soil_box<3>({2, 6, 2}, {0.3, 1.0, 0.2}), soil, 0.06);
}

/// A thin layer whose water is always still: only the suction at its bottom is unknown. n(S(s_0 + γy)) over the height
/// is its water, T α(s_0 + γy) over the height what it loses; Runge and Kutta's fourth order in the bottom's suction.
TEST(SeasonColumn, FeddesReductionFollowsTheEquationOfOneCell) {
  const double height = 0.1, porosity = 0.4, rate = 10e-3 / day, dry = 400e3;
  const std::array<double, 4> suctions{1e3, 4e3, 40e3, 300e3};
  const auto mesh = make_soil_box<2>({1, 20}, {0.02, height});
  auto soil = make_soil<2>(1e-4, porosity);
  soil.retention = material::LinearRetention::from_scale(0.05, 1, dry);
  SeepageModel<2> model{&mesh, {soil}, {}};
  model.sinks = {make_sink<2>(mesh, 0.02, rate, suctions)};
  const double first = 2e3;  // suction at the bottom
  fem::SeepageSchedule schedule;
  for (int i = 1; i <= 24; ++i) schedule.outputs.push_back(i * 0.5 * day);
  schedule.first_step = 1;
  schedule.largest_step = 300;
  const auto history = fem::solve_transient_seepage(model, make_still_heads<2>(mesh, -first / gamma_w), schedule);

  const auto alpha = [&](double s) {
    if (s <= suctions[0] || s >= suctions[3]) return 0.0;
    if (s < suctions[1]) return (s - suctions[0]) / (suctions[1] - suctions[0]);
    return s <= suctions[2] ? 1.0 : (suctions[3] - s) / (suctions[3] - suctions[2]);
  };
  const auto growth = [&](double bottom) {  // of the suction, from the slope 0.95/400 kPa of the saturation
    double mean = 0;
    for (int k = 0; k < 400; ++k) mean += alpha(bottom + gamma_w * height * (k + 0.5) / 400) / 400;
    return rate * mean / (height * porosity * 0.95 / dry);
  };
  double s = first, worst = 0, least = 1;
  for (std::size_t i = 0; i < schedule.outputs.size(); ++i) {
    const double dt = 50;
    for (double t = 0; t < 0.5 * day - 1; t += dt) {
      const double a = growth(s), b = growth(s + 0.5 * dt * a), c = growth(s + 0.5 * dt * b), d = growth(s + dt * c);
      s += dt * (a + 2 * b + 2 * c + d) / 6;
    }
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      worst = std::max(worst, std::abs(history.states[i].pressure[n] - (s + gamma_w * mesh.nodes[n][1])));
    least = std::min(least, history.states[i].uptakes[0].actual / history.states[i].uptakes[0].potential);
    EXPECT_NEAR(history.stored[i] + history.uptakes[i][0].actual, 0, 1e-10 * history.uptakes[i][0].actual);
  }
  EXPECT_LT(worst, 5e-4 * s);
  EXPECT_LT(least, 0.1) << "the soil has come near wilting";
  std::printf("one cell: suction to %.1f Pa of %.0f Pa, least share %.3f\n", worst, s, least);
}

/// Rain by day, sun in between, drainage to a water table below; two kinds of plants.
SeepageModel<2> make_garden(const mesh::Mesh<2>& mesh, double width, double height, double conductivity,
                            double rain_rate) {
  SeepageModel<2> model{&mesh, {make_loam(conductivity)}, {}};
  auto rain = make_condition(mesh, "top", HydraulicKind::rain);
  rain.measure = fem::FluxMeasure::vertical;
  for (int d = 0; d < 10; ++d) {
    const double wet = d % 4 == 1 ? rain_rate : 0.0;
    rain.history.push_back({d * day, wet});
    rain.history.push_back({(d + 0.5) * day, wet});
    rain.history.push_back({(d + 0.5) * day, 0.0});
    rain.history.push_back({(d + 1) * day, 0.0});
  }
  model.boundaries = {make_condition(mesh, "bottom", HydraulicKind::pressure, 2e3), rain};
  model.sinks = {make_sink<2>(mesh, width, 4e-3 / day, {1e3, 2.5e3, 15e3, 120e3}, height - 0.3),
                 make_sink<2>(mesh, 0.5 * width, 2e-3 / day, {0, 0, 30e3, 1.5e6})};
  model.sinks[1].rate = {{0.0, 3 * day, 3 * day, 8 * day}, {0.0, 2e-3 / day, 5e-3 / day, 1e-3 / day}};
  return model;
}

TEST(SeasonColumn, BudgetOfRainTranspirationAndDrainageCloses) {
  const auto mesh = make_soil_box<2>({2, 24}, {0.2, 1.2});
  const auto model = make_garden(mesh, 0.2, 1.2, 2e-6, 4e-7);
  fem::SeepageSchedule schedule;
  for (int i = 1; i <= 10; ++i) schedule.outputs.push_back(i * day);
  schedule.head_tolerance = 0.01;
  const auto heads = make_still_heads<2>(mesh, -0.5);
  const auto history = fem::solve_transient_seepage(model, heads, schedule);
  for (std::size_t i = 0; i < history.states.size(); ++i) {
    double in = 0, out = 0, drawn = 0, asked = 0;
    for (const auto& d : history.volumes[i]) in += d.inflow, out += d.outflow;
    for (const auto& u : history.uptakes[i]) drawn += u.actual, asked += u.potential;
    const double stored = fem::find_stored_water(model, history.states[i].head) - fem::find_stored_water(model, heads);
    EXPECT_NEAR(stored, in - out - drawn, 1e-8 * drawn) << i;
    EXPECT_GT(drawn, 0.3 * asked);
    EXPECT_LE(drawn, asked);
  }
  // Steps end at the corners of a table: the potential of the second sink is its integral, up to implicit Euler on
  // slopes.
  const double exact = 0.1 * (0.5 * 3 * 2e-3 + 5 * 0.5 * (5e-3 + 1e-3) + 2 * 1e-3);
  EXPECT_NEAR(history.uptakes.back()[1].potential, exact, 0.01 * exact);
}

TEST(SeasonColumn, TotalDoesNotDependOnTheMesh) {
  std::vector<double> drawn, suction;
  for (const int n : {12, 24, 48, 96}) {
    const auto mesh = make_soil_box<2>(
        {1, n}, {0.1, 1.2}, [](const Vec<2>&) { return 0; }, 0);
    const auto model = make_garden(mesh, 0.1, 1.2, 2e-8, 1.5e-8);
    fem::SeepageSchedule schedule;
    schedule.outputs = {10 * day};
    schedule.first_step = 10;
    schedule.head_tolerance = 0.003;
    const auto history = fem::solve_transient_seepage(model, make_still_heads<2>(mesh, -0.5), schedule);
    drawn.push_back(history.uptakes[0][0].actual + history.uptakes[0][1].actual);
    const double asked = history.uptakes[0][0].potential + history.uptakes[0][1].potential;
    EXPECT_LT(drawn.back(), 0.9 * asked) << "reduced";
    suction.push_back(*std::max_element(history.states[0].pressure.begin(), history.states[0].pressure.end()));
    std::printf("%d cells: %.5g m3 of %.5g, %.4g kPa, %d steps\n", n, drawn.back(), asked, suction.back() / 1e3,
                history.steps);
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(drawn[i], drawn[3], 0.01 * drawn[3]);
  EXPECT_NEAR(drawn[2], drawn[3], 0.002 * drawn[3]);
  EXPECT_NEAR(suction[2], suction[3], 0.02 * suction[3]);
}

TEST(SeasonColumn, SteadyStateUnderPlantsIsWhereLongTimesLead) {
  const auto mesh = make_soil_box<2>({1, 24}, {0.1, 1.2});
  SeepageModel<2> model{&mesh, {make_loam(2e-6)}, {make_condition(mesh, "bottom", HydraulicKind::pressure, 0.0)}};
  model.sinks = {make_sink<2>(mesh, 0.1, 4e-3 / day, {1e3, 2.5e3, 8e3, 60e3}, 0.9)};
  const auto steady = fem::solve_steady_seepage(model);
  EXPECT_LT(relative_balance(steady), 1e-9);
  EXPECT_NEAR(steady.inflow, steady.transpired, 1e-9 * steady.inflow);
  EXPECT_LT(steady.transpired, 0.99 * steady.uptakes[0].potential) << "reduced";
  fem::SeepageSchedule schedule;
  schedule.outputs = {400 * day};
  const auto history = fem::solve_transient_seepage(model, make_still_heads<2>(mesh, 0), schedule);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    EXPECT_NEAR(history.states[0].pressure[i], steady.pressure[i], 1e-4 * 40e3);
}

TEST(SeasonColumn, FaultsOfPlantsAreNamed) {
  const auto mesh = make_soil_box<2>({1, 2}, {0.1, 0.2});
  SeepageModel<2> model{&mesh, {make_loam()}, {}};
  model.sinks = {make_sink<2>(mesh, 0.1, 1e-8, {4e3, 1e3, 8e3, 60e3})};
  const auto message = [&] {
    try {
      fem::solve_transient_seepage(model, make_still_heads<2>(mesh, 0), {0, {1.0}});
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(message().find("must increase"), std::string::npos);
  model.sinks[0].reduction.suctions = {0, 0, 8e3, 60e3};
  model.sinks[0].rate.value = {-1e-8};
  EXPECT_NE(message().find("\"grass\" have a potential transpiration of -1e-08 m/s"), std::string::npos);
}

}  // namespace
}  // namespace talus
