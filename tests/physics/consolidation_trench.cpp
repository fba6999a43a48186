// SPDX-License-Identifier: MIT
// A trench in elastic ground: its excavation moves the ground as the released stresses of its faces do, in one stage or
// in two.

#include <gtest/gtest.h>

#include <cmath>

#include "support/consolidation_model.hpp"

namespace talus {
namespace {

using support::WetBox;

constexpr double width = 20, height = 10, weight = 18e3, pressure_ratio = 0.6;
constexpr double left = 9, right = 11, bottom = 6, middle = 8;  // of the trench, and the floor of its first stage

struct Ground {
  WetBox box;
  mesh::Mesh<2> dug;
  /// Ground without what lies above `floor` in the trench.
  explicit Ground(double floor) : box({{height, 2e7, 1, 0.25, weight}}, width, 0.8, make_plan()), dug(box.mesh) {
    for (std::size_t e = 0; e < dug.elements.size(); ++e) {
      Vec<2> x{};
      for (const int node : dug.elements[e])
        for (std::size_t d = 0; d < 2; ++d) x[d] += dug.nodes[static_cast<std::size_t>(node)][d] / 3;
      if (x[0] > left && x[0] < right && x[1] > floor) dug.element_region[e] = mesh::empty_region;
    }
    box.solid.mesh = box.flow.mesh = &dug;
    box.solid.point_stress.clear();
    for (const auto& x : fem::make_quadratic<2>(box.mesh).points) {
      const double v = -weight * (height - x[1]);
      box.solid.point_stress.push_back({pressure_ratio * v, v, pressure_ratio * v, 0, 0, 0});
    }
    box.model.drainage = fem::StageDrainage::drained;
    for (const auto& x : box.mesh.nodes) box.model.steady_head.push_back(x[1]);
  }
  static mesh::Plan make_plan() {
    mesh::Plan plan;
    plan.lines = {{"faces", {{left, height}, {left, bottom}, {right, bottom}, {right, height}}},
                  {"first floor", {{left, middle}, {right, middle}}}};
    return plan;
  }
  fem::ConsolidationState<2> run(const fem::ConsolidationState<2>& start) const {
    fem::ConsolidationSchedule schedule;
    schedule.duration = 10;
    schedule.threads = 1;
    const auto result = fem::run_stage(box.model, start, schedule);
    EXPECT_TRUE(result.converged);
    return result.outputs.back().at;
  }
  fem::ConsolidationState<2> carry(const Ground& before, const fem::ConsolidationState<2>& state) const {
    return fem::carry_state(before.box.model, state, box.model, box.model.steady_head);
  }
  fem::ConsolidationState<2> make_first() const { return fem::make_first_state(box.model, box.model.steady_head); }
};

double find_difference(const fem::ConsolidationState<2>& a, const fem::ConsolidationState<2>& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.solid.displacement.size(); ++n)
    for (std::size_t d = 0; d < 2; ++d)
      most = std::max(most, std::abs(a.solid.displacement[n][d] - b.solid.displacement[n][d]));
  return most;
}

TEST(ConstructionStages, TrenchMovesAsItsReleasedStresses) {
  const Ground whole(height), half(middle), trench(bottom);
  const auto start = whole.run(whole.make_first());
  for (const auto& u : start.solid.displacement) EXPECT_LT(norm(u), 1e-9);
  const auto dug = trench.run(trench.carry(whole, start));
  // Superposition: the same ground without weight under the stresses that its faces have lost.
  Ground released(bottom);
  auto& solid = released.box.solid;
  solid.point_stress.clear();
  solid.unit_weight.assign(solid.unit_weight.size(), 0);
  const auto find_vertical = [](double y) { return weight * (height - y); };
  for (const double x : {left, right}) {
    const auto face = support::find_sides<2>(
        released.dug, [x](const Vec<2>& at) { return std::abs(at[0] - x) < 1e-9 && at[1] > bottom - 1e-9; });
    ASSERT_FALSE(face.empty());
    support::add_load<2>(solid, face, {});
    for (std::size_t s = 0; s < face.size(); ++s)
      for (std::size_t i = 0; i < 2; ++i)
        solid.loads.back().traction[s][i][0] =
            (x == left ? 1 : -1) * pressure_ratio *
            find_vertical(released.dug.nodes[static_cast<std::size_t>(face[s][i])][1]);
  }
  support::add_load<2>(solid,
                       support::find_sides<2>(released.dug,
                                              [](const Vec<2>& at) {
                                                return std::abs(at[1] - bottom) < 1e-9 && at[0] > left - 1e-9 &&
                                                       at[0] < right + 1e-9;
                                              }),
                       {0, find_vertical(bottom)});
  const auto superposed = released.run(released.make_first());
  double most = 0;
  for (const auto& u : superposed.solid.displacement) most = std::max(most, norm(u));
  EXPECT_GT(most, 1e-3);
  EXPECT_LT(find_difference(dug, superposed), 1e-6 * most);
  const auto two = trench.run(trench.carry(half, half.run(half.carry(whole, start))));
  EXPECT_LT(find_difference(dug, two), 1e-6 * most);
}

}  // namespace
}  // namespace talus
