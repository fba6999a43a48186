// SPDX-License-Identifier: MIT
// Soil whose conductivity differs along and across its bedding: refracted flow, the transformed section, keys of a
// case.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "input/read.hpp"
#include "physics/seepage_box.hpp"
#include "site/flow_section.hpp"
#include "site/initial_water.hpp"

namespace talus {
namespace {

using namespace support;

/// Soil with `along` in the direction of `inclination` [rad] and `across` at right angles to it [m/s].
HydraulicSoil<2> make_bedded(double along, double across, double inclination) {
  HydraulicSoil<2> soil = make_soil<2>(1);
  const double c = std::cos(inclination), s = std::sin(inclination);
  soil.conductivity = {along * c * c + across * s * s, along * s * s + across * c * c};
  soil.cross_conductivity = (along - across) * s * c;
  return soil;
}

/// Heads on the whole border of a box.
fem::HydraulicBoundary<2> make_border(const mesh::Mesh<2>& mesh, const std::function<double(const Vec<2>&)>& head) {
  fem::HydraulicBoundary<2> border;
  border.name = "border";
  border.kind = HydraulicKind::seepage_face;
  for (const char* side : {"left", "right", "bottom", "top"})
    border.sides.insert(border.sides.end(), mesh.sides.at(side).begin(), mesh.sides.at(side).end());
  for (const Vec<2>& x : mesh.nodes) border.levels.push_back(head(x));
  return border;
}

TEST(SeepageAnisotropy, RefractsUniformFlowBetweenTwoBeddings) {
  // Two soils on both sides of x = 1 with the flux q across it and the gradient t along it: −∇H = (g, t) with
  // q = K_xx g + K_xy t in each. Elements have these heads exactly.
  const auto mesh = make_soil_box<2>(
      {12, 12}, {2, 2}, [](const Vec<2>& x) { return x[0] < 1 ? 0 : 1; }, 0);
  SeepageModel<2> model{&mesh, {make_bedded(1e-5, 1e-6, 0.4), make_bedded(3e-7, 2e-6, -0.9)}, {}};
  const double q = 2e-6, t = 0.3;
  const auto find_fall = [&](std::size_t soil) {
    return (q - model.soils[soil].cross_conductivity * t) / model.soils[soil].conductivity[0];
  };
  const auto find_head = [&](const Vec<2>& x) { return 40 - find_fall(x[0] < 1 ? 0 : 1) * (x[0] - 1) - t * x[1]; };
  model.boundaries = {make_border(mesh, find_head)};
  const auto flow = fem::solve_steady_seepage<2>(model);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) EXPECT_NEAR(flow.head[i], find_head(mesh.nodes[i]), 1e-9);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto soil = static_cast<std::size_t>(mesh.element_region[e]);
    EXPECT_NEAR(flow.velocity[e][0], q, 1e-9 * q);
    EXPECT_NEAR(flow.velocity[e][1],
                model.soils[soil].cross_conductivity * find_fall(soil) + model.soils[soil].conductivity[1] * t,
                1e-9 * q);
  }
  double discharge = 0;
  for (const site::FlowPart& p : site::FlowSections(model).find_parts({{0.3, 0.2}, {0.9, 1.7}, {1.6, 1.7}}))
    discharge += dot(flow.velocity[static_cast<std::size_t>(p.element)], p.normal);
  const auto find_upward = [&](std::size_t soil) {
    return model.soils[soil].cross_conductivity * find_fall(soil) + model.soils[soil].conductivity[1] * t;
  };
  EXPECT_NEAR(discharge, q * 1.5 - 0.7 * find_upward(0) - 0.6 * find_upward(1), 1e-9 * q);
}

TEST(SeepageAnisotropy, FollowsTheTransformedSection) {
  // With X = x'/√k₁, Y = y'/√k₂ along and across the bedding the flow is that of isotropic soil: H = X² − Y² is a
  // solution. The error falls with the square of the size.
  const double along = 4, across = 0.25, inclination = 0.5;  // times 1e-6 m/s
  const auto find_head = [&](const Vec<2>& x) {
    const double c = std::cos(inclination), s = std::sin(inclination);
    const double one = (x[0] * c + x[1] * s) / std::sqrt(along), two = (x[1] * c - x[0] * s) / std::sqrt(across);
    return 60 + one * one - two * two;
  };
  double before = 0;
  for (const int cells : {12, 24}) {
    const auto mesh = make_soil_box<2>({cells, cells}, {2, 2});
    SeepageModel<2> model{&mesh, {make_bedded(along * 1e-6, across * 1e-6, inclination)}, {}};
    model.boundaries = {make_border(mesh, find_head)};
    const auto flow = fem::solve_steady_seepage<2>(model);
    double largest = 0;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      largest = std::max(largest, std::abs(flow.head[i] - find_head(mesh.nodes[i])));
    EXPECT_LT(largest, cells == 12 ? 0.1 : 0.4 * before);
    before = largest;
  }
}

TEST(SeepageAnisotropy, DrainsFreelyByItsVerticalConductivity) {
  // Horizontal bedding, water at the ground: q = K_yy under a gradient of 1.
  const auto mesh = make_soil_box<2>({4, 8}, {1, 2});
  SeepageModel<2> model{&mesh, {make_bedded(1e-5, 1e-6, 0)}, {}};
  model.boundaries = {make_condition(mesh, "top", HydraulicKind::total_head, 2),
                      make_condition(mesh, "bottom", HydraulicKind::free_drainage)};
  const auto flow = fem::solve_steady_seepage<2>(model);
  EXPECT_NEAR(flow.outflow, 1e-6, 1e-12);
}

TEST(SeepageAnisotropy, HasTheKeysOfTheCase) {
  const input::Case data = input::read_case_text(R"(
analysis.methods = ["seepage"]
mesh.size = 1
geometry.polygon = [{ name = "soil", points = [[0, 0], [2, 0], [2, 2], [0, 2]] }]
regions.soil = "clay"
hydraulic = [{ on = "bottom", condition = "total_head", head = 4 }, { on = "top", condition = "total_head", head = 3 }]
[materials.clay]
porosity = 0.4
[materials.clay.water]
retention = "saturated"
conductivity = 8e-8
conductivity_ratio = 0.25
conductivity_inclination = 30
)",
                                                 "flow.toml")
                               .data;
  const auto mesh = make_box_mesh<2>({2, 2}, {2, 2}, {"soil"}, [](const Vec<2>&) { return 0; });
  mesh::Mesh<2> wet;
  const fem::SeepageModel<2> model = site::make_seepage_model<2>(data, mesh, wet);
  EXPECT_NEAR(model.soils[0].conductivity[0], 8e-8 * 0.75 + 2e-8 * 0.25, 1e-20);
  EXPECT_NEAR(model.soils[0].conductivity[1], 8e-8 * 0.25 + 2e-8 * 0.75, 1e-20);
  EXPECT_NEAR(model.soils[0].cross_conductivity, 6e-8 * std::sqrt(3.0) / 4, 1e-20);
}

}  // namespace
}  // namespace talus
