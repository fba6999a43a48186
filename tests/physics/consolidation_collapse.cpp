// SPDX-License-Identifier: MIT
// A strip on clay with effective strength: loaded at once it fails at Prandtl's load with the undrained strength that
// follows from the effective one, loaded slowly at that with the effective strength; its factor without drainage.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fem/consolidation/undrained_factor.hpp"
#include "support/consolidation_model.hpp"

namespace talus {
namespace {

using support::degree;

constexpr double cohesion = 5e3, friction = 20 * degree, confinement = 50e3;

/// Half of a strip of 2 m on weightless soil under an even pressure, which is its initial stress.
struct Strip {
  support::WetBox box{{{5, 1e7, 1e-9}}, 8, 0.5};

  explicit Strip(double load, double dilatancy) {
    auto& solid = box.solid;
    solid.point_stress.assign(3 * box.mesh.elements.size(), {-confinement, -confinement, -confinement, 0, 0, 0});
    solid.make_law = [dilatancy](int, double factor) -> material::Law {
      return material::MohrCoulomb(material::LinearElastic::from_young(1e7, 0.3),
                                   material::MohrCoulombStrength{cohesion, friction, dilatancy, 1e9}.reduced(factor));
    };
    support::add_load<2>(solid, support::find_sides_at<2>(box.mesh, 1, 5), {0, -confinement});
    support::add_load<2>(
        solid, support::find_sides<2>(box.mesh, [](const Vec<2>& x) { return x[1] > 5 - 1e-9 && x[0] < 1 + 1e-9; }),
        {0, -load});
    // Water at rest without pressure: its weight does not count here.
    box.model.steady_head = make_level();
  }
  std::vector<double> make_level() const {
    std::vector<double> head;
    for (const auto& x : box.mesh.nodes) head.push_back(x[1]);
    return head;
  }
  /// The load at which the soil flows [Pa].
  double find_collapse(double load, fem::StageDrainage drainage, double duration) {
    box.model.drainage = drainage;
    fem::ConsolidationSchedule schedule;
    schedule.duration = duration;
    schedule.load_steps = 26;
    schedule.most_halvings = 4;
    schedule.most_iterations = 40;
    schedule.threads = 1;
    const auto result = fem::run_stage(box.model, fem::make_first_state(box.model, make_level()), schedule);
    EXPECT_FALSE(result.converged);
    return result.reached * load;
  }
};

TEST(ConsolidationCollapse, UndrainedStripFailsAtPrandtlsLoad) {
  // The mean stress in the plane stays, so that s_u = c cos φ + p_0 sin φ.
  const double strength = cohesion * std::cos(friction) + confinement * std::sin(friction);
  const double expected = (2 + std::numbers::pi) * strength, load = 1.3 * expected;
  Strip strip(load, 0);
  const double found = strip.find_collapse(load, fem::StageDrainage::undrained, 0);
  EXPECT_GT(found, 0.99 * expected);
  EXPECT_LT(found, 1.05 * expected);
}

TEST(ConsolidationCollapse, FactorWithoutDrainageIsThatOfPrandtlsLoad) {
  // F divides c and tan φ of the undrained strength: (2 + π)(c/F cos φ_F + p_0 sin φ_F) = load, tan φ_F = tan φ/F.
  const auto find_load = [](double factor) {
    const double reduced = std::atan(std::tan(friction) / factor);
    return (2 + std::numbers::pi) * (cohesion / factor * std::cos(reduced) + confinement * std::sin(reduced));
  };
  const double load = 0.7 * find_load(1);
  double low = 1, high = 2;
  while (high - low > 1e-6) (find_load(0.5 * (low + high)) > load ? low : high) = 0.5 * (low + high);
  Strip strip(load, 0);
  strip.box.model.drainage = fem::StageDrainage::undrained;
  fem::ConsolidationSchedule schedule;
  schedule.load_steps = 8;
  schedule.threads = 1;
  const auto loaded =
      fem::run_stage(strip.box.model, fem::make_first_state(strip.box.model, strip.make_level()), schedule);
  ASSERT_TRUE(loaded.converged);
  fem::UndrainedOptions options;
  options.resolution = 0.01;
  options.most_displacement = 1.25;
  options.most_iterations = 40;
  options.threads = 1;
  const auto found = fem::reduce_undrained(strip.box.model, loaded.outputs.back().at, options);
  EXPECT_GT(found.failed, 0.99 * low);
  EXPECT_LT(found.stable, 1.06 * low);
  EXPECT_LE(found.failed - found.stable, 0.01 + 1e-12);
  // At the fixed pore pressures of the loaded strip the soil would bear more.
  fem::SolidModel<2> fixed = strip.box.solid;
  const auto& state = loaded.outputs.back().at;
  fixed.point_stress = state.solid.stress;
  fixed.pore_stress = fem::find_corner_stress<2>(strip.box.model, state.head);
  fem::SolidOptions solid;
  solid.threads = 1;
  EXPECT_TRUE(fem::find_equilibrium<2>(fixed, solid, 1.03 * found.failed).converged);
}

TEST(ConsolidationCollapse, DrainedStripFailsAtPrandtlsLoad) {
  const double tan = std::tan(friction), root = std::tan(45 * degree + friction / 2);
  const double n_q = root * root * std::exp(std::numbers::pi * tan), n_c = (n_q - 1) / tan;
  const double expected = cohesion * n_c + confinement * (n_q - 1), load = 1.3 * expected;
  Strip strip(load, friction);
  const double found = strip.find_collapse(load, fem::StageDrainage::drained, 100);
  EXPECT_GT(found, 0.99 * expected);
  EXPECT_LT(found, 1.06 * expected);
}

}  // namespace
}  // namespace talus
