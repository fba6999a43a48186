// SPDX-License-Identifier: MIT
// Gibson's layer: clay that settles out of water on an impermeable base, built in thin lifts that consolidate while
// they are placed.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "support/consolidation_model.hpp"

namespace talus {
namespace {

using support::WetBox;

constexpr double thickness = 10, oedometric = 1e6, conductivity = 1e-9, submerged = 6e3;
constexpr double c_v = conductivity * oedometric / support::water_weight;

/// u/(γ' h) in a layer that grows at a constant rate, h = m t, at the height X h above its base (Gibson 1958, with
/// ξ = 2 s √(c_v t) in his integral), for T = m² t/c_v = m h/c_v.
double find_gibson(double x, double factor) {
  const double root = std::sqrt(factor), end = root / 2 + 8;
  constexpr int intervals = 2000;  // of Simpson's rule
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double s = end * i / intervals;
    // cosh(x √T s) exp(-s² - x² T/4) without overflow
    const double bells =
        0.5 * (std::exp(-std::pow(s - 0.5 * x * root, 2)) + std::exp(-std::pow(s + 0.5 * x * root, 2)));
    sum += (i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2) * s * std::tanh(root * s) * bells;
  }
  return 1 - 4 / (std::sqrt(std::numbers::pi) * root) * sum * end / (3 * intervals);
}

/// A layer in lifts below water that stands at the level of its final top.
class GrowingLayer {
 public:
  GrowingLayer(int lifts, double factor)
      : lift_(thickness / lifts),
        time_(thickness * thickness / (factor * c_v)),
        box_(std::vector<support::WetLayer>(static_cast<std::size_t>(lifts), make_layer(lift_)), lift_, lift_) {}

  /// Largest error of the excess pressures against Gibson's at the end of growth, over γ' h.
  double find_error(double factor) {
    const int lifts = static_cast<int>(box_.layers.size());
    auto stage = make_stage(1);
    auto state = fem::make_first_state(stage->model, std::vector<double>(box_.mesh.nodes.size(), thickness));
    for (int k = 1; k <= lifts; ++k) {
      auto next = make_stage(k);
      state = fem::carry_state(stage->model, state, next->model, std::vector<double>(state.head.size(), thickness));
      fem::ConsolidationSchedule schedule;
      schedule.start = (k - 1) * time_ / lifts;
      schedule.duration = time_ / lifts;
      schedule.threads = 1;
      const auto result = fem::run_stage(next->model, state, schedule);
      EXPECT_TRUE(result.converged) << k;
      state = result.outputs.back().at;
      stage = std::move(next);
    }
    double error = 0;
    for (std::size_t n = 0; n < box_.mesh.nodes.size(); ++n)
      error = std::max(error, std::abs(box_.find_excess(state, n) / (submerged * thickness) -
                                       find_gibson(box_.mesh.nodes[n][1] / thickness, factor)));
    return error;
  }

 private:
  static support::WetLayer make_layer(double height) {
    return {height, oedometric, conductivity, 0, submerged + support::water_weight};
  }
  struct Stage {
    mesh::Mesh<2> mesh;
    fem::SolidModel<2> solid;
    fem::SeepageModel<2> flow;
    fem::ConsolidationModel<2> model;
  };
  /// The layer with its first `count` lifts, loaded and drained by the water above them.
  std::unique_ptr<Stage> make_stage(int count) const {
    auto stage = std::make_unique<Stage>(Stage{box_.mesh, box_.solid, box_.flow, {}});
    for (std::size_t e = 0; e < stage->mesh.elements.size(); ++e)
      if (std::stoi(stage->mesh.region_names[static_cast<std::size_t>(stage->mesh.element_region[e])].substr(6)) >=
          count)
        stage->mesh.element_region[e] = mesh::empty_region;
    stage->solid.mesh = stage->flow.mesh = &stage->mesh;
    stage->solid.point_stress.clear();
    const double top = count * lift_;
    const auto ground = support::find_sides_at<2>(stage->mesh, 1, top);
    support::add_load<2>(stage->solid, ground, {0, -support::water_weight * (thickness - top)});
    fem::HydraulicBoundary<2> water;
    water.name = "water";
    water.kind = fem::HydraulicKind::total_head;
    water.sides = ground;
    water.value = thickness;
    stage->flow.boundaries = {water};
    stage->model.solid = &stage->solid;
    stage->model.flow = &stage->flow;
    return stage;
  }

  double lift_, time_;
  WetBox box_;
};

TEST(ConsolidationGrowth, GibsonsIntegralHasItsLimits) {
  // No excess at the surface; slow growth is steady flow, u = γ' m (h² - y²)/(2 c_v); at the base of fast growth the
  // drainage of tanh = 1 remains.
  for (const double factor : {0.01, 1.0, 16.0, 100.0}) EXPECT_NEAR(find_gibson(1, factor), 0, 1e-9) << factor;
  EXPECT_NEAR(find_gibson(0.5, 0.001), 0.001 * 0.75 / 2, 2e-6);
  EXPECT_NEAR(find_gibson(0, 1e4), 1 - 2 / std::sqrt(std::numbers::pi * 1e4), 1e-6);
}

TEST(ConsolidationGrowth, LiftsApproachGibsonsLayer) {
  // A lift is there at the start of its stage, so that the surface leads by half a lift on average: the error falls in
  // proportion to the thickness of the lifts, more slowly where the gradient at the surface is steep.
  for (const double factor : {1.0, 4.0, 16.0}) {
    std::vector<double> errors;
    for (const int lifts : {10, 20, 40}) errors.push_back(GrowingLayer(lifts, factor).find_error(factor));
    EXPECT_LT(errors[2], 0.01) << factor;
    EXPECT_GT(errors[0] / errors[1], 1.5) << factor;
    EXPECT_GT(errors[1] / errors[2], 1.6) << factor;
  }
}

}  // namespace
}  // namespace talus
