// SPDX-License-Identifier: MIT
// Energy balance: it closes in loose sand that slides, opens and closes, and in saturated soil with flow; null modes of
// the points' velocities are filtered without a change of momentum.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "material/every_law.hpp"
#include "support/point_soils.hpp"
#include "support/soil_body.hpp"
#include "support/wet_case.hpp"

namespace talus {
namespace {

enum class Floor { rough, frictional };

/// A block of sand, 2 m by 1 m, that comes along at 3 m/s; meshes of that many elements over its height.
struct SandBlock {
  int cells = 5;
  mpm::Body<2> body;
  mpm::StepOptions<2> options;
  double start = 0, smallest_step = INFINITY, largest_step = 0;

  SandBlock(Floor floor, input::Smoothing smoothing) {
    const material::MohrCoulomb sand(material::LinearElastic::from_young(5e6, 0.3), {0, 0.52, 0, 0});
    const double density = 1590, gravity = 9.81;
    body = support::fill_body<2>(
        support::make_mesh<2>({12 * cells, 3 * cells}, {12, 3}), {{sand, density}}, 3,
        [](const Vec<2>& x) { return x[0] > 1 && x[0] < 3 && x[1] < 1 ? 0 : -1; },
        [&](mpm::InitialPoint<2>& p, const Vec<2>& x) {
          p.velocity[0] = 3;
          p.stress[1] = -density * gravity * (1 - x[1]);
          p.stress[0] = p.stress[2] = 0.5 * p.stress[1];
        });
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
      if (body.mesh().nodes[i][1] > 1e-9) continue;
      auto& c = support::get_constraint(body, i);
      if (floor == Floor::rough) {
        c.fixed_count = 2;
        c.fixed[0] = {1, 0};
        c.fixed[1] = {0, 1};
      } else {
        c.has_wall = true;
        c.wall_normal = {0, -1};
        c.friction = 0.3;
      }
    }
    options.gravity = {0, -gravity};
    options.mixed = true;
    options.smoothing = smoothing;
    mpm::gather_nodal_sums(body, options);
    start = sum_energy();
  }

  /// Energy and what became of it, without gravity's [J].
  double sum_energy() const {
    const auto t = mpm::sum_points(body, options.gravity);
    const mpm::Work& w = body.work;
    return t.kinetic + t.elastic + w.dissipated + w.damped + w.walls + w.mapping;
  }
  void run(double duration) {
    while (body.time < duration) {
      if (body.step_count % 32 == 0) {
        options.dt = 0.9 * mpm::find_critical_step(body, 1).dt;
        smallest_step = std::min(smallest_step, options.dt);
        largest_step = std::max(largest_step, options.dt);
      }
      mpm::step(body, options);
      if (body.step_count % 64 == 0) mpm::filter_null_modes(body, options);
    }
  }
};

TEST(EngineEnergy, SandBlockPaysForItsSlideOnAnyFloor) {
  for (const Floor floor : {Floor::rough, Floor::frictional}) {
    for (const input::Smoothing smoothing : {input::Smoothing::none, input::Smoothing::stable}) {
      SandBlock block(floor, smoothing);
      const auto before = mpm::sum_points(block.body, block.options.gravity);
      block.run(2);
      const mpm::Work& w = block.body.work;
      const auto after = mpm::sum_points(block.body, block.options.gravity);
      const double work = before.kinetic + w.external, residual = w.external + block.start - block.sum_energy();
      const std::string name = (floor == Floor::rough ? "rough" : "frictional") +
                               std::string(smoothing == input::Smoothing::none ? "" : ", smoothed");
      EXPECT_LT(std::abs(residual), 0.01 * work) << name;
      EXPECT_NEAR(w.external, before.potential - after.potential, 1e-9 * work) << name;
      EXPECT_GT(w.mapping, 0) << name;
      EXPECT_GT(w.walls, 0) << name;
      EXPECT_GT(w.dissipated, 0.3 * work) << name;
      EXPECT_GT(block.smallest_step, 0.9 * block.largest_step) << name << ": loose sand does not swell";
      double gap = 0, volume = 0, before_volume = 0;
      support::for_each_point(block.body, [&](int, const mpm::PointView<2>& p) {
        gap = std::max(gap, material::find_gap(block.body.laws[p.material], p.state.data()));
        volume += p.volume;
        before_volume += p.mass / 1590;
      });
      EXPECT_GT(gap, 0.1) << name << ": it comes apart";
      EXPECT_NEAR(volume / before_volume, 1, 0.01) << name;
    }
  }
}

/// A cliff of 1 m of saturated sand collapses and lets water out.
void expect_saturated_soil_to_pay(input::WaterMotion water, double largest) {
  input::Material soil = support::make_wet_soil(5e6);
  soil.model = material::model_of<material::MohrCoulomb>;
  soil.friction_angle = 0.52;
  soil.water.conductivity = 1e-3;
  input::Case data = support::make_box_case<2>(soil);
  data.water.bulk_modulus = 2e7;
  mpm::Body<2> body = run::prepare<2>(data, support::make_step_mesh<2>());
  const auto before = mpm::sum_points(body, {0, -9.81});
  run::StageState state;
  run::run_stage(body, support::make_stage(data, body, 1, {.smoothing = input::Smoothing::none, .water = water}),
                 state);
  const auto after = mpm::sum_points(body, {0, -9.81});
  const mpm::Work& w = body.work;
  const double lost = w.dissipated + w.damped + w.walls + w.mapping + w.drag + w.pore_water;
  const double residual = w.external + before.kinetic + before.elastic - after.kinetic - after.elastic - lost;
  EXPECT_LT(std::abs(residual), largest * w.external);
  EXPECT_GT(w.dissipated, 0.5 * w.external);
  if (water == input::WaterMotion::seeps) return;  // what sinks through the pores works on nothing
  EXPECT_GT(w.drag, 0.01 * w.external);
  EXPECT_NEAR(w.external, before.potential - after.potential, 0.01 * w.external);
}

TEST(EngineEnergy, SaturatedSoilPaysForItsSlideAndItsFlow) {
  expect_saturated_soil_to_pay(input::WaterMotion::flows, 0.01);
}
TEST(EngineEnergy, SaturatedSoilInTheDarcyFormulationClosesItsBudget) {
  expect_saturated_soil_to_pay(input::WaterMotion::seeps, 0.02);  // 0.4 % on the meshes of tools/verify_energy.py
}

TEST(EngineEnergy, NullModesAreFilteredAndMomentumIsConserved) {
  // A free block that moves and turns, with noise on the velocities of its points.
  std::mt19937 random(3);
  const auto draw = [&] { return 2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1; };
  mpm::Body<2> body = support::fill_body<2>(
      support::make_mesh<2>({20, 20}, {2, 2}), {{material::LinearElastic::from_young(1e5, 0.3), 1800}}, 6,
      [](const Vec<2>& x) { return std::abs(x[0] - 1) < 0.5 && std::abs(x[1] - 1) < 0.5 ? 0 : -1; },
      [&](mpm::InitialPoint<2>& p, const Vec<2>& x) {
        p.velocity = {0.3 - 2 * (x[1] - 1) + 0.5 * draw(), 0.1 + 2 * (x[0] - 1) + 0.5 * draw()};
      });
  mpm::StepOptions<2> o;
  mpm::gather_nodal_sums(body, o);
  const auto measure = [&] {
    std::array<double, 3> m{};
    double unaffine = 0;
    support::for_each_point(body, [&](int, const mpm::PointView<2>& p) {
      for (std::size_t d = 0; d < 2; ++d) m[d] += p.mass * p.velocity[d];
      m[2] += p.mass * ((p.position[0] - 1) * p.velocity[1] - (p.position[1] - 1) * p.velocity[0]);
      unaffine = std::max(unaffine, std::hypot(p.velocity[0] - 0.3 + 2 * (p.position[1] - 1),
                                               p.velocity[1] - 0.1 - 2 * (p.position[0] - 1)));
    });
    return std::pair(m, unaffine);
  };
  const auto [before, noise] = measure();
  const double kinetic = mpm::sum_points(body, {}).kinetic;
  mpm::filter_null_modes(body, o);
  const auto [after, rest] = measure();
  EXPECT_NEAR(after[0], before[0], 1e-12 * std::abs(before[0]));
  EXPECT_NEAR(after[1], before[1], 1e-12 * std::abs(before[0]));
  EXPECT_NEAR(after[2], before[2], 1e-4 * std::abs(before[2]));
  EXPECT_NEAR(mpm::sum_points(body, {}).kinetic + body.work.mapping, kinetic, 1e-12 * kinetic);
  EXPECT_GT(body.work.mapping, 0.02 * kinetic) << "most of the noise is unseen: 6 points in an element";
  EXPECT_LT(rest, noise);
  // Once more finds next to nothing; and the nodal sums are those of the points.
  const double once = body.work.mapping;
  mpm::filter_null_modes(body, o);
  EXPECT_LT(body.work.mapping - once, 0.02 * once);
  const auto sums = body.nodes.sums;
  mpm::gather_nodal_sums(body, o);
  for (std::size_t i = 0; i < sums.size(); ++i) ASSERT_NEAR(sums[i], body.nodes.sums[i], 1e-9);
}

TEST(EngineEnergy, TheFilterKeepsAffineMotion) {
  mpm::Body<2> body = support::fill_body<2>(
      support::make_mesh<2>({12, 12}, {2, 2}), {{material::LinearElastic::from_young(1e5, 0.3), 1800}}, 3,
      [](const Vec<2>& x) { return std::abs(x[0] - 1) < 0.6 && std::abs(x[1] - 1) < 0.6 ? 0 : -1; },
      [&](mpm::InitialPoint<2>& p, const Vec<2>& x) {
        p.velocity = {0.3 - 2 * (x[1] - 1) + 0.7 * x[0], 0.1 + 2 * (x[0] - 1)};
      });
  mpm::StepOptions<2> o;
  mpm::gather_nodal_sums(body, o);
  const double kinetic = mpm::sum_points(body, {}).kinetic;
  for (int n = 0; n < 10; ++n) mpm::filter_null_modes(body, o);
  EXPECT_LT(body.work.mapping, 1e-5 * kinetic);
}

}  // namespace
}  // namespace talus
