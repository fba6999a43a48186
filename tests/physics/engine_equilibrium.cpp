// SPDX-License-Identifier: MIT
// States of rest: uniform stress on any mesh, columns under their weight, loads, layers; and their invariances.

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "support/box_case.hpp"
#include "support/draw.hpp"
#include "support/soil_body.hpp"

namespace talus {
namespace {

using results::StageEnd;
using support::Mode;

template <class Dimension>
class EngineEquilibrium : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(EngineEquilibrium, Dimensions);

template <int D>
std::array<int, D> cut(int x, int y, int z) {
  if constexpr (D == 2)
    return {x, y};
  else
    return {x, y, z};
}
template <int D>
Vec<D> extent(double x, double y, double z) {
  if constexpr (D == 2)
    return {x, y};
  else
    return {x, y, z};
}

const material::LinearElastic firm = material::LinearElastic::from_young(5e6, 0.3);

TYPED_TEST(EngineEquilibrium, UniformStressStaysInEquilibriumOnAJitteredMesh) {
  constexpr int D = TypeParam::value;
  const Vec<D> size = extent<D>(2, 1.5, 1.5);
  for (const Mode& mode : support::all_modes()) {
    mpm::Body<D> body = support::fill_body<D>(
        support::make_mesh<D>(cut<D>(7, 5, 4), size), {{firm, 1800}}, D == 2 ? 3 : 4, [](const Vec<D>&) { return 0; },
        [](mpm::InitialPoint<D>& p, const Vec<D>&) {
          p.stress = {-10e3, -7e3, -4e3, 2e3};
          if constexpr (D == 3) p.stress[4] = -1e3, p.stress[5] = 0.5e3;
        },
        3);
    for (int d = 0; d < D; ++d) {
      support::fix_nodes<D>(body, d, [&](const Vec<D>& x) {
        bool outer = false;
        for (std::size_t i = 0; i < D; ++i) outer = outer || x[i] < 1e-9 || x[i] > size[i] - 1e-9;
        return outer;
      });
    }
    mpm::StepOptions<D> o;
    o.dt = 0.5 * mpm::find_critical_step(body, 1).dt;
    o.mixed = mode.mixed;
    o.smoothing = mode.smoothing;
    mpm::gather_nodal_sums(body, o);
    support::run_steps(body, o, 200);
    support::for_each_point(body, [&](int, const mpm::PointView<D>& p) {
      EXPECT_LT(norm(p.velocity), 1e-11) << mode.name;
      EXPECT_NEAR(p.stress[0], -10e3, 1e-6) << mode.name;
      EXPECT_NEAR(p.stress[3], 2e3, 1e-6) << mode.name;
    });
  }
}

TYPED_TEST(EngineEquilibrium, LinearBoundaryDisplacementGivesUniformStrain) {
  constexpr int D = TypeParam::value;
  // The patch test: boundary nodes move by ε·x, the inner ones find their places by themselves.
  const Vec<D> size = extent<D>(2, 1.5, 1.5);
  const double strain[3][3] = {{1e-3, 4e-4, -3e-4}, {2e-4, -2e-3, 5e-4}, {1e-4, -2e-4, 8e-4}};
  for (const Mode& mode : support::all_modes()) {
    mpm::Body<D> body = support::fill_body<D>(support::make_mesh<D>(cut<D>(6, 5, 4), size), {{firm, 1800}},
                                              D == 2 ? 3 : 4, [](const Vec<D>&) { return 0; });
    const double ramp = 0.02;
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
      const Vec<D>& x = body.mesh().nodes[i];
      bool outer = false;
      for (std::size_t d = 0; d < D; ++d) outer = outer || x[d] < 1e-9 || x[d] > size[d] - 1e-9;
      if (!outer) continue;
      Vec<D> velocity{};
      for (std::size_t a = 0; a < D; ++a) {
        for (std::size_t b = 0; b < D; ++b) velocity[a] += strain[a][b] * x[b] / ramp;
      }
      support::move_node<D>(body, i, velocity, {{0, ramp, ramp * 1.001}, {1, 1, 0}});
    }
    mpm::StepOptions<D> o;
    o.dt = 0.7 * mpm::find_critical_step(body, 1).dt;
    o.mixed = mode.mixed;
    o.smoothing = mode.smoothing;
    o.moving = false;
    o.objective = false;
    o.damping = 0.7;
    mpm::gather_nodal_sums(body, o);
    support::run_steps(body, o, static_cast<int>(ramp / o.dt) + 500);
    // The actual result of the ramp is the same everywhere; one corner node gives it.
    double given = 0;
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
      const Vec<D>& x = body.mesh().nodes[i];
      if (x[0] > size[0] - 1e-9 && x[1] < 1e-9 && (D == 2 || x[D - 1] < 1e-9))
        given = body.nodes.displacement[i][0] / (strain[0][0] * size[0]);
    }
    EXPECT_NEAR(given, 1, 0.1);
    support::for_each_point(body, [&](int, const mpm::PointView<D>& p) {
      EXPECT_NEAR(p.strain[0], given * strain[0][0], 1e-8) << mode.name;
      EXPECT_NEAR(p.strain[1], given * strain[1][1], 1e-8) << mode.name;
      EXPECT_NEAR(p.strain[3], given * (strain[0][1] + strain[1][0]), 1e-8) << mode.name;
      if constexpr (D == 3) {
        EXPECT_NEAR(p.strain[5], given * (strain[0][2] + strain[2][0]), 1e-8) << mode.name;
      }
    });
  }
}

TYPED_TEST(EngineEquilibrium, K0ColumnIsExactAndStaysAtRest) {
  constexpr int D = TypeParam::value;
  const double height = 3;
  const auto mesh =
      support::make_box_mesh<D>(cut<D>(3, 9, 2), extent<D>(1, height, 0.7), {"soil"}, [](const Vec<D>&) { return 0; });
  input::Case data = support::make_box_case<D>(support::make_elastic());
  data.initial.stress = input::InitialStress::k0;
  for (const double k0 : {0.3 / 0.7, 1.2}) {
    data.initial.k0 = k0;
    mpm::Body<D> body = run::prepare<D>(data, mesh);
    support::for_each_point(body, [&](int, const mpm::PointView<D>& p) {
      const double vertical = -1800 * 9.81 * (height - p.position[1]);
      EXPECT_NEAR(p.stress[1], vertical, 1e-9 * 1800 * 9.81 * height);
      EXPECT_NEAR(p.stress[0], k0 * vertical, 1e-9 * 1800 * 9.81 * height);
      EXPECT_NEAR(p.stress[2], k0 * vertical, 1e-9 * 1800 * 9.81 * height);
    });
    // Linear stresses have their element mean in the middle, so both integrations are exact.
    for (const auto integration : {input::Integration::mixed, input::Integration::points}) {
      mpm::Body<D> resting = body;
      const auto plan = support::make_stage(
          data, resting, 0.2, {.damping = 0, .integration = integration, .smoothing = input::Smoothing::none});
      EXPECT_EQ(support::run_plan(resting, plan), StageEnd::time);
      EXPECT_LT(resting.monitor.out_of_balance, 1e-9 * resting.monitor.external);
      EXPECT_LT(resting.monitor.speed, 1e-9);
      EXPECT_LT(mpm::find_largest_displacement(resting).value, 1e-10);
    }
  }
}

/// A column that settles under its weight, from no stress.
template <int D>
mpm::Body<D> settle(const input::Case& data, const mesh::Mesh<D>& mesh, input::StepSettings step, double longest = 5,
                    double force_ratio = 1e-6) {
  mpm::Body<D> body = run::prepare<D>(data, mesh);
  EXPECT_EQ(support::run_plan(body, support::make_rest_stage(data, body, longest, step, force_ratio)), StageEnd::rest);
  return body;
}

TYPED_TEST(EngineEquilibrium, ColumnSettlesToTheWeightAboveEachPoint) {
  constexpr int D = TypeParam::value;
  const double height = 2, rho = 1800, g = 9.81;
  const auto mesh = support::make_box_mesh<D>(cut<D>(2, 8, 2), extent<D>(0.5, height, 0.5), {"soil"},
                                              [](const Vec<D>&) { return 0; });
  const input::Case data = support::make_box_case<D>(support::make_elastic(50e6));
  for (const Mode& mode : support::all_modes()) {
    const auto body = settle<D>(data, mesh,
                                {.damping = 0.75,
                                 .integration = mode.mixed ? input::Integration::mixed : input::Integration::points,
                                 .smoothing = mode.smoothing});
    double rms = 0;
    int n = 0;
    support::for_each_point(body, [&](int, const mpm::PointView<D>& p) {
      const double error = p.stress[1] + rho * g * (height - p.position[1]);
      rms += error * error;
      ++n;
      // a linear simplex holds one stress: half an element's height of weight is the largest error of a point
      EXPECT_NEAR(p.stress[1], -rho * g * (height - p.position[1]), 0.8 * rho * g * height / 8) << mode.name;
    });
    EXPECT_LT(std::sqrt(rms / n), 0.35 * rho * g * height / 8) << mode.name;
  }
}

TYPED_TEST(EngineEquilibrium, TractionsOnSidesAndOnPointsCompressAColumnByTheAppliedStress) {
  constexpr int D = TypeParam::value;
  const double height = 1, q = 20e3, e = 20e6, nu = 0.25;
  const auto mesh = support::make_box_mesh<D>(cut<D>(3, 10, 2), extent<D>(0.3, height, 0.2), {"soil"},
                                              [](const Vec<D>&) { return 0; });
  input::Case data = support::make_box_case<D>(support::make_elastic(e, nu, 1800));
  data.gravity.acceleration = 1e-6;  // the rest criterion compares with √(gH)
  for (const auto carrier : {input::Carrier::sides, input::Carrier::points}) {
    data.tractions = {{.on = "top", .carrier = carrier, .traction = {0, -q, 0}, .factor = {{0, 0.05}, {0, 1}}}};
    mpm::Body<D> body = run::prepare<D>(data, mesh);
    auto plan = support::make_rest_stage(data, body, 5, {.damping = 0.75, .smoothing = input::Smoothing::none});
    plan.rest.speed_ratio = 1e-2;
    plan.rest.hold = 0.06;
    EXPECT_EQ(support::run_plan(body, plan), StageEnd::rest);
    const double constrained = e * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    // Forces on points act below the surface; a few elements deeper the stress is uniform (Saint-Venant).
    const double loaded = carrier == input::Carrier::sides ? height : 0.5 * height;
    double mean = 0, volume = 0;
    support::for_each_point(body, [&](int, const mpm::PointView<D>& p) {
      if (p.position[1] > loaded) return;
      EXPECT_NEAR(p.stress[1], -q, (carrier == input::Carrier::sides ? 1e-4 : 0.01) * q);
      EXPECT_NEAR(p.strain[1], -q / constrained, (carrier == input::Carrier::sides ? 1e-3 : 0.01) * q / constrained);
      mean += p.volume * p.stress[1];
      volume += p.volume;
    });
    EXPECT_NEAR(mean / volume, -q, 2e-3 * q);
  }
}

TEST(EngineEquilibriumPlane, LayersOfTwoMaterialsCarryTheirWeights) {
  const auto mesh = support::make_box_mesh<2>(
      {3, 10}, {0.6, 2}, {"lower", "upper"}, [](const Vec<2>& x) { return x[1] < 1 ? 0 : 1; }, 0);
  input::Case data = support::make_box_case<2>(support::make_elastic());
  data.materials = {{"clay", support::make_elastic(40e6, 0.3, 1600)}, {"sand", support::make_elastic(20e6, 0.2, 2000)}};
  data.regions = {{"lower", "clay"}, {"upper", "sand"}};
  data.initial.stress = input::InitialStress::k0;
  mpm::Body<2> body = run::prepare<2>(data, mesh);
  const auto expect_stress = [&](double tolerance) {
    support::for_each_point(body, [&](int, const mpm::PointView<2>& p) {
      const double y = p.position[1];
      const double vertical = y > 1 ? -2000 * 9.81 * (2 - y) : -2000 * 9.81 - 1600 * 9.81 * (1 - y);
      const double nu = y > 1 ? 0.2 : 0.3;
      EXPECT_NEAR(p.stress[1], vertical, tolerance * 40e3);
      EXPECT_NEAR(p.stress[0], nu / (1 - nu) * vertical, tolerance * 40e3);
    });
  };
  expect_stress(1e-9);
  EXPECT_EQ(support::run_plan(body, support::make_stage(data, body, 0.1, {.integration = input::Integration::points})),
            StageEnd::time);
  expect_stress(1e-8);
  EXPECT_LT(body.monitor.out_of_balance, 1e-9 * body.monitor.external);
}

TEST(EngineEquilibriumPlane, LocalDampingHasNoEffectOnTheStateOfRest) {
  const auto mesh = support::make_box_mesh<2>({6, 6}, {2, 1.5}, {"soil"},
                                              [](const Vec<2>& x) { return x[1] < 1.5 - 0.4 * x[0] ? 0 : -1; });
  const input::Case data = support::make_box_case<2>(support::make_elastic(20e6));
  const auto weak = settle<2>(data, mesh, {.damping = 0.3}, 20, 1e-7),
             strong = settle<2>(data, mesh, {.damping = 0.8}, 20, 1e-7);
  for (int id = 0; id < weak.points.size(); ++id) {
    const auto a = mpm::view_point(weak, id), b = mpm::view_point(strong, id);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(a.stress[i], b.stress[i], 1e-3 * 20e3);
    EXPECT_NEAR(a.displacement[1], b.displacement[1], 1e-3 * 2e-3);
  }
}

TEST(EngineEquilibriumPlane, MassScalingGivesTheSameStateOfRestInLargerSteps) {
  const auto mesh = support::make_box_mesh<2>({4, 6}, {1, 1.5}, {"soil"}, [](const Vec<2>&) { return 0; });
  const input::Case data = support::make_box_case<2>(support::make_elastic(20e6));
  const auto light = settle<2>(data, mesh, {.damping = 0.75, .mass_scaling = 1}, 20, 1e-8);
  const auto heavy = settle<2>(data, mesh, {.damping = 0.75, .mass_scaling = 16}, 20, 1e-8);
  EXPECT_NEAR(mpm::find_critical_step(heavy, 16).dt / mpm::find_critical_step(heavy, 1).dt, 4, 1e-12);
  for (int id = 0; id < light.points.size(); ++id) {
    const auto a = mpm::view_point(light, id), b = mpm::view_point(heavy, id);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a.stress[i], b.stress[i], 1e-4 * 25e3);
  }
}

}  // namespace
}  // namespace talus
