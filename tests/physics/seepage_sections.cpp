// SPDX-License-Identifier: MIT
// The discharge through lines that end in the soil, against stream functions and the flow of the boundary.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "physics/seepage_box.hpp"
#include "site/flow_section.hpp"

namespace talus {
namespace {

using namespace support;
using Function = std::function<double(const Vec<2>&)>;

double compute_discharge(const SeepageModel<2>& model, const fem::SeepageResult<2>& flow,
                         const std::vector<Vec<2>>& line) {
  double sum = 0;
  for (const site::FlowPart& p : site::FlowSections(model).find_parts(line))
    for (std::size_t d = 0; d < 2; ++d) sum += flow.velocity[static_cast<std::size_t>(p.element)][d] * p.normal[d];
  return sum;
}

/// A box of 2 m with two soils on both sides of 1 m along an axis, irregular but on the border and between the soils.
mesh::Mesh<2> make_two_soils(std::size_t axis, double jitter) {
  auto mesh = make_soil_box<2>(
      {16, 16}, {2, 2}, [&](const Vec<2>& x) { return x[axis] < 1 ? 0 : 1; }, 0);
  for (auto& x : mesh.nodes) {
    const Vec<2> at = x;
    const bool is_inside = std::abs(at[0] - 1) < 0.95 && std::abs(at[1] - 1) < 0.95 && std::abs(at[axis] - 1) > 0.05;
    if (is_inside)
      x = {at[0] + jitter * std::sin(40 * at[0] + 7 * at[1]), at[1] + jitter * std::cos(9 * at[0] - 50 * at[1])};
  }
  mesh::finish(mesh, mesh::Order::as_given);
  return mesh;
}

/// Heads that vary along the whole border of the box.
fem::HydraulicBoundary<2> make_heads(const mesh::Mesh<2>& mesh, const Function& head) {
  fem::HydraulicBoundary<2> border;
  border.name = "border";
  border.kind = HydraulicKind::seepage_face;
  for (const char* side : {"left", "right", "bottom", "top"})
    border.sides.insert(border.sides.end(), mesh.sides.at(side).begin(), mesh.sides.at(side).end());
  for (const Vec<2>& x : mesh.nodes) border.levels.push_back(head(x));
  return border;
}

/// Lines in a box of 2 m: slanted, along sides of elements, within one element, bent, through the border.
const std::vector<std::vector<Vec<2>>> lines{
    {{0.3, 0.4}, {1.7, 1.2}},         {{0.25, 1}, {1.75, 1}}, {{1, 0.125}, {1, 1.5}}, {{0.9, 0.7}, {0.92, 0.71}},
    {{0.2, 1.9}, {1, 1}, {1.6, 0.2}}, {{-1, 0.6}, {3, 1.3}},  {{1, 1}, {1.3, 1}},     {{0.99, 0.3}, {1.01, 0.3}}};

/// The parts of a line in the box.
std::array<Vec<2>, 2> find_ends(const std::vector<Vec<2>>& line) {
  if (line.front()[0] >= 0) return {line.front(), line.back()};
  const auto at = [&](double x) {
    const double s = (x - line[0][0]) / (line[1][0] - line[0][0]);
    return Vec<2>{x, line[0][1] + s * (line[1][1] - line[0][1])};
  };
  return {at(0), at(2)};
}

TEST(SeepageSections, HaveTheFlowBetweenTheirEndsInRefractedFlow) {
  // Two soils on both sides of x = 1, k 1000:1, with the flux q across it and the gradient t along it: the heads are
  // linear in each, as in its elements.
  const double k[2] = {1e-5, 1e-8}, q = 3e-9, t = 0.2;
  for (const double jitter : {0.0, 0.03}) {
    const auto mesh = make_two_soils(0, jitter);
    const auto find_soil = [](const Vec<2>& x) { return x[0] < 1 ? 0 : 1; };
    SeepageModel<2> model{&mesh, {make_soil<2>(k[0]), make_soil<2>(k[1])}, {}};
    model.boundaries = {
        make_heads(mesh, [&](const Vec<2>& x) { return 20 - q / k[find_soil(x)] * (x[0] - 1) - t * x[1]; })};
    const auto flow = fem::solve_steady_seepage<2>(model);
    const Function stream = [&](const Vec<2>& x) { return q * x[1] - k[find_soil(x)] * t * (x[0] - 1); };
    for (const auto& line : lines) {
      const auto [a, b] = find_ends(line);
      EXPECT_NEAR(compute_discharge(model, flow, line), stream(b) - stream(a), 1e-9 * k[0] * t)
          << line.front()[0] << " " << line.front()[1] << " " << jitter;
    }
  }
}

TEST(SeepageSections, HaveTheFlowThroughTwoLayers) {
  // Upwards through 1 m of sand and 1 m of clay: q = h/(1/k1 + 1/k2), whatever the line's way.
  const auto mesh = make_two_soils(1, 0.03);
  SeepageModel<2> model{&mesh, {make_soil<2>(1e-5), make_soil<2>(1e-8)}, {}};
  model.boundaries = {make_condition(mesh, "bottom", HydraulicKind::total_head, 4.7),
                      make_condition(mesh, "top", HydraulicKind::total_head, 3)};
  const auto flow = fem::solve_steady_seepage<2>(model);
  const double q = 1.7 / (1 / 1e-5 + 1 / 1e-8);
  for (const auto& line : lines) {
    const auto [a, b] = find_ends(line);
    EXPECT_NEAR(compute_discharge(model, flow, line), q * (a[0] - b[0]), 1e-6 * q);
  }
}

TEST(SeepageSections, FollowTheStreamFunctionOfACorner) {
  // H = (x² - y²)/2 about a corner has the stream function xy. The error falls with the square of the size.
  double before = 0;
  for (const int cells : {12, 24}) {
    const auto mesh = make_soil_box<2>({cells, cells}, {2, 2});
    SeepageModel<2> model{&mesh, {make_soil<2>(1e-5)}, {}};
    model.boundaries = {make_heads(mesh, [](const Vec<2>& x) { return 20 - (x[0] * x[0] - x[1] * x[1]) / 2; })};
    const auto flow = fem::solve_steady_seepage<2>(model);
    double largest = 0;
    for (const auto& line : lines) {
      const auto [a, b] = find_ends(line);
      const double exact = 1e-5 * (b[0] * b[1] - a[0] * a[1]);
      largest = std::max(largest, std::abs(compute_discharge(model, flow, line) - exact) / 1e-5);
      EXPECT_NEAR(compute_discharge(model, flow, {line.rbegin(), line.rend()}), -compute_discharge(model, flow, line),
                  1e-16);
    }
    EXPECT_LT(largest, cells == 12 ? 0.02 : 0.3 * before);
    before = largest;
  }
}

TEST(SeepageSections, AddUpAndCloseInUnsaturatedFlow) {
  // Between impermeable sides the flow is that of the boundary, and parts of a line add up; soil whose conductivity
  // falls with suction conserves water as well.
  const auto mesh = make_soil_box<2>({12, 12}, {2, 2});
  SeepageModel<2> model{&mesh, {make_soil<2>(1e-5)}, {}};
  model.soils[0].retention = material::LinearRetention::from_scale(0.1, 1, 0.5 * gamma_w);
  model.soils[0].relative =
      material::make_conductivity_table({{0, 1}, {0.5 * gamma_w, 1e-3}}, material::Interpolation::linear, false);
  model.boundaries = {make_condition(mesh, "left", HydraulicKind::reservoir, 1.6),
                      make_condition(mesh, "right", HydraulicKind::reservoir, 0.4)};
  const auto flow = fem::solve_steady_seepage<2>(model);
  EXPECT_NEAR(compute_discharge(model, flow, {{0.7, 0}, {1.2, 2}}), flow.inflow, 1e-9 * flow.inflow);
  const Vec<2> a{0.7, 0}, b{0.9, 0.37}, c{1.1, 1.03};
  EXPECT_NEAR(compute_discharge(model, flow, {a, b}) + compute_discharge(model, flow, {b, c}),
              compute_discharge(model, flow, {a, c}), 1e-9 * flow.inflow);
}

}  // namespace
}  // namespace talus
