// SPDX-License-Identifier: MIT
// Orders of convergence on closed-form solutions of a bar in uniaxial strain. With linear simplices, small
// displacements and points that fill their elements the scheme is a linear finite element method: second order in
// displacement, first order in stress. The order in time, which is one, is tested by the energies in
// physics/engine_waves.cpp.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "mpm/solver/step.hpp"
#include "support/soil_body.hpp"

namespace talus {
namespace {

constexpr double young = 10e6, poisson = 0.25, density = 2000, length = 2;

double find_modulus() {
  return young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
}

/// A bar along y on a floor between frictionless walls, on a jittered mesh of `cells` elements over its length.
mpm::Body<2> make_bar(int cells, const support::Start<2>& start = {}) {
  const double h = length / cells, width = 3 * h;
  mpm::Body<2> body = support::fill_body<2>(
      support::make_mesh<2>({3, cells}, {width, length}),
      {{material::LinearElastic::from_young(young, poisson), density}}, 3, [](const Vec<2>&) { return 0; }, start);
  support::fix_nodes<2>(body, 0, [&](const Vec<2>& x) { return x[0] < 1e-9 || x[0] > width - 1e-9; });
  support::fix_nodes<2>(body, 1, [](const Vec<2>& x) { return x[1] < 1e-9; });
  return body;
}

/// Slope of ln(error) over ln(size), least squares.
double fit_order(const std::vector<double>& size, const std::vector<double>& error) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const double n = static_cast<double>(size.size());
  for (std::size_t i = 0; i < size.size(); ++i) {
    const double x = std::log(size[i]), y = std::log(error[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TEST(ElasticBar, SettlementUnderSelfWeightIsOfSecondOrderAndStressOfFirst) {
  for (const bool moving : {false, true}) {
    std::vector<double> size, displacement, stress;
    for (const int cells : {8, 16, 32}) {
      mpm::Body<2> body = make_bar(cells);
      mpm::StepOptions<2> o;
      o.mixed = true;
      o.moving = moving;
      o.damping = 0.7;
      o.gravity[1] = -1;
      o.dt = 0.8 * mpm::find_critical_step(body, 1).dt;
      mpm::gather_nodal_sums(body, o);
      support::run_steps(body, o, 120 * cells);
      double u2 = 0, s2 = 0, volume = 0;
      support::for_each_point(body, [&](int id, const mpm::PointView<2>& p) {
        const double y = body.points.reference[static_cast<std::size_t>(id)][1];
        const double u = -density / find_modulus() * (length * y - 0.5 * y * y), s = -density * (length - y);
        u2 += p.volume * (p.displacement[1] - u) * (p.displacement[1] - u);
        s2 += p.volume * (p.stress[1] - s) * (p.stress[1] - s);
        volume += p.volume;
      });
      size.push_back(1.0 / cells);
      displacement.push_back(std::sqrt(u2 / volume));
      stress.push_back(std::sqrt(s2 / volume));
    }
    const double order = fit_order(size, displacement);
    // Points that have moved no longer fill their elements exactly: a little of the order is lost.
    EXPECT_GT(order, moving ? 1.5 : 1.9) << moving;
    EXPECT_LT(order, 2.3) << moving;
    EXPECT_NEAR(fit_order(size, stress), 1, 0.15) << moving;
  }
}

/// Error of the first mode after a quarter of `periods`, with the step a fixed fraction of the critical one.
double measure_mode_error(int cells, double courant, double periods) {
  const double wave = std::numbers::pi / (2 * length), speed = std::sqrt(find_modulus() / density),
               omega = wave * speed, v0 = 1e-4;
  mpm::Body<2> body =
      make_bar(cells, [&](mpm::InitialPoint<2>& p, const Vec<2>& x) { p.velocity[1] = v0 * std::sin(wave * x[1]); });
  mpm::StepOptions<2> o;
  o.mixed = true;
  const double end = periods * 2 * std::numbers::pi / omega;
  const int steps = static_cast<int>(std::ceil(end / (courant * mpm::find_critical_step(body, 1).dt)));
  o.dt = end / steps;
  mpm::gather_nodal_sums(body, o);
  support::run_steps(body, o, steps);
  double sum = 0, volume = 0;
  support::for_each_point(body, [&](int id, const mpm::PointView<2>& p) {
    const double exact =
        v0 / omega * std::sin(wave * body.points.reference[static_cast<std::size_t>(id)][1]) * std::sin(omega * end);
    sum += p.volume * (p.displacement[1] - exact) * (p.displacement[1] - exact);
    volume += p.volume;
  });
  return std::sqrt(sum / volume) / (v0 / omega);
}

TEST(ElasticBar, FirstModeConvergesWithTheMesh) {
  std::vector<double> size, error;
  for (const int cells : {8, 16, 32}) {
    size.push_back(1.0 / cells);
    error.push_back(measure_mode_error(cells, 0.02, 0.25));  // so small a step that space rules
  }
  EXPECT_GT(fit_order(size, error), 1.8);
  EXPECT_LT(error.back(), 2e-3);
}

}  // namespace
}  // namespace talus
