// SPDX-License-Identifier: MIT
// Stages of construction: undrained compression, excavation and placing of elastic soil, stages that are cut in two,
// and Mandel's slab with its rise of the pore pressure.

#include <gtest/gtest.h>

#include <cmath>

#include "support/consolidation_model.hpp"

namespace talus {
namespace {

using support::WetBox;

constexpr double young = 1e7, conductivity = 1e-8;

fem::ConsolidationSchedule make_schedule(double duration, std::vector<double> outputs = {}) {
  fem::ConsolidationSchedule schedule;
  schedule.duration = duration;
  schedule.outputs = std::move(outputs);
  schedule.threads = 1;
  return schedule;
}

/// The box with the upper layer empty, as before it is placed or after it is removed.
struct HalfBox {
  WetBox whole, half;
  mesh::Mesh<2> lower;
  HalfBox(const std::vector<support::WetLayer>& layers, double width, double size)
      : whole(layers, width, size), half(layers, width, size), lower(whole.mesh) {
    for (std::size_t e = 0; e < lower.elements.size(); ++e)
      if (lower.region_names[static_cast<std::size_t>(lower.element_region[e])] == "layer 1")
        lower.element_region[e] = mesh::empty_region;
    half.solid.mesh = half.flow.mesh = &lower;
  }
};

TEST(ConstructionStages, UndrainedColumnCompressesWithTheModulusOfWaterAndSkeleton) {
  // u_y = −q H/M_u, M_u = E_oed + K_w/n.
  WetBox box({{2, young, conductivity}}, 0.5, 0.25);
  const double modulus = 2e7, load = 50e3;
  for (auto& soil : box.flow.soils) soil.water_modulus = modulus;
  box.press_top(load);
  const auto state = box.press_undrained(box.make_start());
  const double u = -state.solid.displacement[box.find_node(0, 2)][1], expected = load * 2 / (young + modulus / 0.4);
  EXPECT_NEAR(u, expected, 1e-4 * expected);
}

TEST(ConstructionStages, ExcavationHeavesTheRest) {
  // 4 of 10 m are removed from a confined elastic column: heave γ h_exc h_rest/E_oed, and the stress of the rest alone
  // remains at the base.
  const double weight = 17e3, lower_weight = 18e3;
  HalfBox boxes({{6, young, conductivity, 0, lower_weight}, {4, young, conductivity, 0, weight}}, 2, 1);
  boxes.whole.solid.point_stress.clear();
  boxes.half.solid.point_stress.clear();
  boxes.whole.model.drainage = boxes.half.model.drainage = fem::StageDrainage::drained;
  boxes.whole.model.steady_head = boxes.half.model.steady_head = std::vector<double>(boxes.whole.mesh.nodes.size(), 0);
  for (std::size_t n = 0; n < boxes.whole.mesh.nodes.size(); ++n)
    boxes.whole.model.steady_head[n] = boxes.half.model.steady_head[n] = boxes.whole.mesh.nodes[n][1];
  const auto dry = fem::make_first_state(boxes.whole.model, boxes.whole.model.steady_head);
  const auto full = fem::run_stage(boxes.whole.model, dry, make_schedule(0));
  ASSERT_TRUE(full.converged);
  auto start = full.outputs.back().at;
  std::fill(start.solid.displacement.begin(), start.solid.displacement.end(), Vec<2>{});
  const auto carried = fem::carry_state(boxes.whole.model, start, boxes.half.model, boxes.half.model.steady_head);
  const auto result = fem::run_stage(boxes.half.model, carried, make_schedule(10));
  ASSERT_TRUE(result.converged);
  const auto& end = result.outputs.back().at;
  const double heave = end.solid.displacement[boxes.whole.find_node(0, 6)][1], expected = weight * 4 * 6 / young;
  EXPECT_NEAR(heave, expected, 1e-6 * expected);
  const auto mesh = fem::make_quadratic<2>(boxes.lower);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    EXPECT_NEAR(end.solid.stress[p][1], -lower_weight * (6 - mesh.points[p][1]), 1e-6 * lower_weight * 6);
  EXPECT_GT(result.start_imbalance, 0.1);
}

TEST(ConstructionStages, LiftsCompressWhatIsBelow) {
  // A layer of 4 m placed on one of 6 m: the lower one settles by γ h h_rest/E_oed, the placed one by its own weight.
  const double weight = 17e3;
  HalfBox boxes({{6, young, conductivity, 0, 0}, {4, young, conductivity, 0, weight}}, 2, 1);
  boxes.whole.solid.point_stress.clear();
  boxes.half.solid.point_stress.clear();
  std::vector<double> level;
  for (const auto& x : boxes.whole.mesh.nodes) level.push_back(x[1]);
  for (auto* box : {&boxes.whole, &boxes.half})
    box->model.drainage = fem::StageDrainage::drained, box->model.steady_head = level;
  const auto start = fem::make_first_state(boxes.half.model, level);
  const auto carried = fem::carry_state(boxes.half.model, start, boxes.whole.model, level);
  const auto end = fem::run_stage(boxes.whole.model, carried, make_schedule(10)).outputs.back().at;
  const double below = -end.solid.displacement[boxes.whole.find_node(0, 6)][1],
               above = -end.solid.displacement[boxes.whole.find_node(0, 10)][1];
  EXPECT_NEAR(below, weight * 4 * 6 / young, 1e-6 * below);
  EXPECT_NEAR(above - below, weight * 4 * 4 / (2 * young), 1e-6 * above);
}

TEST(ConstructionStages, TwoHalvesEndWhereTheWholeEnds) {
  WetBox box({{1, young, conductivity}}, 0.5, 0.25), half({{1, young, conductivity}}, 0.5, 0.25);
  box.press_top(100e3);
  half.press_top(50e3);
  const auto whole = box.press_undrained(box.make_start());
  const auto two = box.press_undrained(half.press_undrained(half.make_start()));
  for (std::size_t n = 0; n < whole.solid.displacement.size(); ++n)
    EXPECT_NEAR(whole.solid.displacement[n][1], two.solid.displacement[n][1], 1e-12);
  for (std::size_t n = 0; n < whole.head.size(); ++n) EXPECT_NEAR(whole.head[n], two.head[n], 1e-7);
}

TEST(ConstructionStages, LoweringOfTheWaterTableSettles) {
  // Lowering a table in a confined column: s = γ_w (y_hi − y_lo)/E_oed (y_lo + (y_hi − y_lo)/2). Above it suction is
  // not taken, so that the pressure is zero there.
  WetBox box({{10, young, conductivity}}, 2, 0.5);
  const double high = 9, low = 5;
  box.solid.point_stress.clear();
  const auto set = [&](double level) {
    std::vector<double> head;
    for (const auto& x : box.mesh.nodes) head.push_back(std::max(level, x[1]));
    return head;
  };
  box.model.drainage = fem::StageDrainage::drained;
  box.model.steady_head = set(high);
  const auto first = fem::run_stage(box.model, fem::make_first_state(box.model, set(high)), make_schedule(0));
  ASSERT_TRUE(first.converged);
  auto start = first.outputs.back().at;
  std::fill(start.solid.displacement.begin(), start.solid.displacement.end(), Vec<2>{});
  box.model.steady_head = set(low);
  const auto last = fem::run_stage(box.model, start, make_schedule(10));
  ASSERT_TRUE(last.converged);
  const auto& end = last.outputs.back().at;
  const double s = -end.solid.displacement[box.find_node(0, 10)][1],
               expected = support::water_weight * (high - low) / young * (low + (high - low) / 2);
  EXPECT_NEAR(s, expected, 1e-3 * expected);
}

/// The pore pressure in Mandel's slab over the mean pressure, at the distance x from its middle over half its width,
/// after Cheng and Detournay (1988), for incompressible water and grains.
double find_mandel(double poisson, double x, double factor) {
  const double ratio = (1 - poisson) / (0.5 - poisson);  // tan α = ratio α
  double sum = 0;
  for (int i = 0; i < 200; ++i) {
    double low = (i + 1e-12) * M_PI, high = (i + 0.5) * M_PI - 1e-12;
    for (int k = 0; k < 200; ++k) {
      const double a = 0.5 * (low + high);
      (std::tan(a) < ratio * a ? low : high) = a;
    }
    const double a = 0.5 * (low + high);
    sum += std::sin(a) / (a - std::sin(a) * std::cos(a)) * (std::cos(a * x) - std::cos(a)) * std::exp(-a * a * factor);
  }
  return sum;
}

TEST(ConstructionStages, SlabOfMandelRisesInItsMiddle) {
  // The upper half of a slab between smooth rigid plates: the plate is a stiff beam on springs across it.
  const double poisson = 0.2, pressure = 100e3, half = 1, height = 0.5;
  WetBox box({{height, young, conductivity, poisson}}, 2 * half, 0.1);
  box.solid.supports.clear();
  support::add_roller<2>(box.solid, 1, 0);
  fem::Support<2> middle_side;  // against sliding as a whole
  middle_side.name = "middle";
  middle_side.sides =
      support::find_sides<2>(box.mesh, [&](const Vec<2>& x) { return x[1] < 1e-9 && std::abs(x[0] - half) < 0.06; });
  middle_side.fixed = {true, false};
  ASSERT_FALSE(middle_side.sides.empty());
  box.solid.supports.push_back(middle_side);
  box.drain(0, 0, height);
  box.drain(0, 2 * half, height);
  fem::Bar plate;
  plate.name = "plate";
  plate.head = {0, height}, plate.end = {2 * half, height};
  plate.axial_stiffness = 1;
  plate.compressive = plate.tensile = fem::unlimited;
  plate.bending_stiffness = 1e13, plate.shear_stiffness = 1e13;
  plate.bond_stiffness = 1e-3, plate.lateral_stiffness = 1e12;
  plate.line_load = {0, -pressure};
  box.solid.bars = {plate};
  const double c = conductivity / support::water_weight * young;  // of one-dimensional compression
  const auto start = box.press_undrained(box.make_start());
  std::vector<double> times;
  const std::vector<double> factors{0.01, 0.05, 0.1, 0.2, 0.5, 1.0};
  for (const double t : factors) times.push_back(t * half * half / c);
  const auto result = fem::run_stage(box.model, start, make_schedule(times.back(), times));
  ASSERT_TRUE(result.converged);
  const std::size_t middle = box.find_node(half + 0.3, height);  // away from the node that is held
  const double off = box.mesh.nodes[middle][0] - half;
  const double first = box.find_excess(start, middle);
  EXPECT_NEAR(first, pressure / 2, 0.01 * pressure);
  double largest = 0;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const double at = box.find_excess(result.outputs[i].at, middle) / pressure;
    largest = std::max(largest, at);
    EXPECT_NEAR(at, find_mandel(poisson, off, factors[i]), 0.01) << factors[i];
  }
  EXPECT_GT(largest, 1.02 * first / pressure);
}

}  // namespace
}  // namespace talus
