// SPDX-License-Identifier: MIT
// Elastic waves and vibrations, and the terms of their energy balance.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/box_case.hpp"
#include "support/soil_body.hpp"

namespace talus {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double young = 10e6, bar_density = 2000;

struct Bar {
  double length = 5, width = 0.2, poisson = 0.25;
  int cells = 50;
  bool mixed = true;
  input::Smoothing smoothing = input::Smoothing::none;
  double damping = 0, courant = 0.5;
  double modulus() const { return young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)); }
  double wave_speed() const { return std::sqrt(modulus() / bar_density); }
};

/// A bar along x between frictionless walls, so in uniaxial strain; the end at 0 is fixed, the other free.
mpm::Body<2> make_bar(const Bar& bar, const support::Start<2>& start) {
  const Vec<2> size{bar.length + 2 * bar.length / bar.cells, bar.width};
  mpm::Body<2> body = support::fill_body<2>(
      support::make_mesh<2>({bar.cells + 2, 2}, size, 0),
      {{material::LinearElastic::from_young(young, bar.poisson), bar_density}}, 3,
      [&](const Vec<2>& x) { return x[0] < bar.length ? 0 : -1; }, start);
  support::fix_nodes<2>(body, 0, [](const Vec<2>& x) { return x[0] < 1e-9; });
  support::fix_nodes<2>(body, 1, [&](const Vec<2>& x) { return x[1] < 1e-9 || x[1] > bar.width - 1e-9; });
  return body;
}

mpm::StepOptions<2> make_options(const Bar& bar, const mpm::Body<2>& body) {
  mpm::StepOptions<2> o;
  o.mixed = bar.mixed;
  o.smoothing = bar.smoothing;
  o.damping = bar.damping;
  o.dt = bar.courant * mpm::find_critical_step(body, 1).dt;
  return o;
}

double mean_velocity(const mpm::Body<2>& body) {
  const auto t = mpm::sum_points(body, {});
  return t.momentum[0] / t.mass;
}

TEST(EngineWaves, FixedFreeBarSwingsWithPeriodFourLengthsOverTheWaveSpeed) {
  for (const support::Mode& mode : support::all_modes()) {
    Bar bar;
    bar.mixed = mode.mixed;
    bar.smoothing = mode.smoothing;
    mpm::Body<2> body = make_bar(bar, [&](mpm::InitialPoint<2>& p, const Vec<2>& x) {
      p.velocity[0] = 1e-3 * std::sin(pi * x[0] / (2 * bar.length));
    });
    const auto o = make_options(bar, body);
    mpm::gather_nodal_sums(body, o);
    // The velocity changes sign at T/4, 3T/4, 5T/4.
    std::vector<double> zeros;
    double last = mean_velocity(body);
    while (zeros.size() < 3 && body.step_count < 20000) {
      mpm::step(body, o);
      const double v = mean_velocity(body);
      if (v * last < 0) zeros.push_back(body.time - o.dt * v / (v - last));
      last = v;
    }
    ASSERT_EQ(zeros.size(), 3u) << mode.name;
    EXPECT_NEAR(zeros[2] - zeros[0], 4 * bar.length / bar.wave_speed(), 0.003 * 4 * bar.length / bar.wave_speed())
        << mode.name;
  }
}

TEST(EngineWaves, FrontOfAPushRunsWithTheWaveSpeedAndCarriesItsStress) {
  Bar bar;
  bar.cells = 200;
  bar.courant = 0.8;
  mpm::Body<2> body = make_bar(bar, {});
  // The fixed end is pushed with a velocity v from the start: σ = -ρ c v behind the front.
  const double v = 1e-3, at = 2.5;
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
    if (body.mesh().nodes[i][0] < 1e-9) support::move_node<2>(body, i, {v, 0});
  }
  auto o = make_options(bar, body);
  mpm::gather_nodal_sums(body, o);
  const auto stress_at = [&](double x) {
    double sum = 0;
    int n = 0;
    support::for_each_point(body, [&](int, const mpm::PointView<2>& p) {
      if (std::abs(p.position[0] - x) > 0.05) return;
      sum += p.stress[0];
      ++n;
    });
    return sum / n;
  };
  const double full = -bar_density * bar.wave_speed() * v;
  // Between two stations, so that the start of the push at the boundary does not matter.
  while (stress_at(1) > 0.5 * full && body.time < 1) mpm::step(body, o);
  const double first = body.time;
  while (stress_at(at) > 0.5 * full && body.time < 1) mpm::step(body, o);
  EXPECT_NEAR(body.time - first, (at - 1) / bar.wave_speed(), 0.01 * at / bar.wave_speed());
  while (body.time < 1.5 * at / bar.wave_speed()) mpm::step(body, o);
  double sum = 0;
  int n = 0;
  for (double x = 0.5; x < 3; x += 0.1, ++n) sum += stress_at(x);
  EXPECT_NEAR(sum / n, full, 0.01 * std::abs(full));
}

/// Energy of a body and its losses, as the engine counts them [J/m].
template <int D>
double sum_energy(const mpm::Body<D>& body, const std::type_identity_t<Vec<D>>& gravity) {
  const auto t = mpm::sum_points(body, gravity);
  return t.kinetic + t.potential + t.elastic + body.work.dissipated + body.work.damped + body.work.walls +
         body.work.mapping;
}

/// Largest change of the energy of a swinging bar in `periods` first periods, over its energy.
double measure_energy_error(const Bar& bar, double periods) {
  mpm::Body<2> body = make_bar(bar, [&](mpm::InitialPoint<2>& p, const Vec<2>& x) {
    p.velocity[0] = 1e-3 * std::sin(pi * x[0] / (2 * bar.length));
  });
  const auto o = make_options(bar, body);
  mpm::gather_nodal_sums(body, o);
  const double start = sum_energy<2>(body, {});
  double worst = 0;
  while (body.time < periods * 4 * bar.length / bar.wave_speed()) {
    mpm::step(body, o);
    if (body.step_count % 4 == 0) worst = std::max(worst, std::abs(sum_energy<2>(body, {}) / start - 1));
  }
  return worst;
}

TEST(EngineEnergy, ErrorOfASwingingBarShrinksLinearlyWithTheTimeStep) {
  for (const bool mixed : {true, false}) {
    Bar bar;
    bar.mixed = mixed;
    bar.courant = 0.8;
    const double coarse = measure_energy_error(bar, 1);
    bar.courant = 0.2;
    const double fine = measure_energy_error(bar, 1);
    EXPECT_LT(coarse, 0.012);
    EXPECT_NEAR(coarse / fine, 4, 0.4) << "first order in the step";
  }
}

TEST(EngineEnergy, ErrorOfADampedBarShrinksWithTheMesh) {
  // The work of local damping is counted on the nodes' paths, the points' energy on theirs: they differ by O(h).
  double error[2];
  int n = 0;
  for (const int cells : {50, 100}) {
    Bar bar;
    bar.cells = cells;
    bar.damping = 0.1;
    bar.courant = 0.2;
    mpm::Body<2> body = make_bar(bar, [&](mpm::InitialPoint<2>& p, const Vec<2>& x) {
      p.velocity[0] = 1e-3 * std::sin(pi * x[0] / (2 * bar.length));
    });
    const auto o = make_options(bar, body);
    mpm::gather_nodal_sums(body, o);
    const double start = sum_energy<2>(body, {});
    while (body.time < 4 * bar.length / bar.wave_speed()) mpm::step(body, o);
    EXPECT_GT(body.work.damped, 0.3 * start);
    error[n++] = std::abs(sum_energy<2>(body, {}) / start - 1);
  }
  EXPECT_LT(error[0], 1e-4);
  EXPECT_LT(error[1], error[0]);
}

TEST(EngineEnergy, FallIsPaidForByPotentialEnergy) {
  // Without contact there is no error but that of the explicit path, ½gΔt per unit of time.
  mpm::Body<2> body = support::fill_body<2>(
      support::make_mesh<2>({8, 16}, {1, 2}), {{material::LinearElastic::from_young(young, 0.3), bar_density}}, 3,
      [](const Vec<2>& x) { return x[1] > 1.2 && std::abs(x[0] - 0.5) < 0.3 ? 0 : -1; });
  mpm::StepOptions<2> o;
  o.gravity[1] = -9.81;
  double error[2];
  int n = 0;
  for (const double dt : {1e-3, 5e-4}) {
    mpm::Body<2> falling = body;
    o.dt = dt;
    mpm::gather_nodal_sums(falling, o);
    const double start = sum_energy<2>(falling, o.gravity);
    support::run_steps(falling, o, static_cast<int>(std::round(0.3 / dt)));
    const auto t = mpm::sum_points(falling, o.gravity);
    EXPECT_LT(std::abs(sum_energy<2>(falling, o.gravity) - start), 1e-11 * t.kinetic) << "the balance closes";
    EXPECT_NEAR(falling.work.external, t.kinetic + falling.work.mapping, 1e-9 * t.kinetic);
    error[n++] = falling.work.mapping / t.kinetic;
  }
  EXPECT_GT(error[1], 0);
  EXPECT_LT(error[0], 0.005);
  EXPECT_NEAR(error[0] / error[1], 2, 0.1);
}

TEST(EngineEnergy, PlasticCollapseDissipatesWhatItsFallSetFree) {
  // A weak block on a floor slumps until it is at rest; gravity's work is then plastic dissipation but for the
  // residual of the mapping, which is bounded here.
  const material::MohrCoulomb soil(material::LinearElastic::from_young(2e6, 0.3), {500, 0.4, 0.0, 300});
  mpm::Body<2> body = support::fill_body<2>(support::make_mesh<2>({40, 12}, {4, 1.2}), {{soil, 1800}}, 3,
                                            [](const Vec<2>& x) { return x[0] < 1 && x[1] < 1 ? 0 : -1; });
  support::fix_nodes<2>(body, 0, [](const Vec<2>& x) { return x[0] < 1e-9 || x[1] < 1e-9; });
  support::fix_nodes<2>(body, 1, [](const Vec<2>& x) { return x[1] < 1e-9; });
  mpm::StepOptions<2> o;
  o.mixed = true;
  o.gravity[1] = -9.81;
  o.dt = 0.6 * mpm::find_critical_step(body, 1).dt;
  mpm::gather_nodal_sums(body, o);
  const double start = sum_energy<2>(body, o.gravity), before = mpm::sum_points(body, o.gravity).potential;
  while (body.time < 2) mpm::step(body, o);
  const auto t = mpm::sum_points(body, o.gravity);
  const double released = before - t.potential;
  EXPECT_GT(released, 500);
  EXPECT_LT(std::abs(sum_energy<2>(body, o.gravity) - start), 0.01 * released);
  EXPECT_GT(body.work.walls, 0) << "the floor stops what falls on it";
  EXPECT_GT(body.work.mapping, 0) << "nothing comes from nothing";
  EXPECT_GT(body.work.dissipated, 0.8 * released);
  EXPECT_LT(t.kinetic, 0.05 * released);
}

}  // namespace
}  // namespace talus
