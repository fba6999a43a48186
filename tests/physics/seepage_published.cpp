// SPDX-License-Identifier: MIT
// Seepage against published solutions: a quarter of a ring, a block under recharge, and an earth dam on rock.

#include <gtest/gtest.h>

#include <numbers>

#include "mesh/generate.hpp"
#include "physics/seepage_box.hpp"

namespace talus {
namespace {

using namespace support;

material::Conductivity make_ramp(double fringe) {
  return material::make_conductivity_table({{0, 1}, {fringe * gamma_w, 1e-3}}, material::Interpolation::linear, false);
}

TEST(SeepagePublished, QuarterOfARing) {
  // Radial flow between r = 10 m (head 30 m) and 30 m (head 10 m): q/k = (π/2) Δh / ln 3 = 28.596
  mesh::Plan plan;
  plan.box_max = {31, 31};
  plan.size = 1.0;
  mesh::Line inner{"inner", {}}, outer{"outer", {}};
  const int n = 48;
  for (int i = 0; i <= n; ++i) {
    const double a = 0.5 * std::numbers::pi * i / n;
    inner.points.push_back({10 * std::cos(a), 10 * std::sin(a)});
    outer.points.push_back({30 * std::cos(a), 30 * std::sin(a)});
  }
  inner.points.front()[1] = outer.points.front()[1] = inner.points.back()[0] = outer.points.back()[0] = 0;
  mesh::Polygon ring{"soil", outer.points};
  ring.points.insert(ring.points.end(), inner.points.rbegin(), inner.points.rend());
  plan.polygons = {ring};
  plan.lines = {inner, outer};
  const auto mesh = mesh::generate<2>(plan);
  SeepageModel<2> model{&mesh, {make_soil<2>(1.0)}, {}};
  model.boundaries = {make_condition(mesh, "inner", HydraulicKind::total_head, 30),
                      make_condition(mesh, "outer", HydraulicKind::total_head, 10)};
  const auto r = fem::solve_steady_seepage(model);
  EXPECT_NEAR(r.discharges[0].inflow / 28.596, 1, 2e-3);
  EXPECT_LT(relative_balance(r), 1e-10);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const double radius = std::hypot(mesh.nodes[i][0], mesh.nodes[i][1]);
    if (radius > 10 && radius < 30) {
      EXPECT_NEAR(r.head[i], 30 - 20 * std::log(radius / 10) / std::log(3), 0.2);  // 1 % of the drop
    }
  }
}

TEST(SeepagePublished, BlockUnderRecharge) {
  // Haar (1990): 10 m between heads 3.75 and 3 m, recharge 2.5e-6 m/s, k = 1e-5 m/s. Highest water table: 4.25 m at
  // x = 3.99 by Dupuit, 4.49 at 4.06 and 4.61 at 4.1 by two programs.
  const auto mesh = make_soil_box<2>({60, 30}, {10, 5});
  auto soil = make_soil<2>(1e-5);
  soil.relative = make_ramp(0.25);
  SeepageModel<2> model{&mesh, {soil}, {}};
  model.boundaries = {make_condition(mesh, "left", HydraulicKind::reservoir, 3.75),
                      make_condition(mesh, "right", HydraulicKind::reservoir, 3),
                      make_condition(mesh, "top", HydraulicKind::flux, 2.5e-6)};
  const auto r = fem::solve_steady_seepage(model);
  EXPECT_LT(relative_balance(r), 1e-10);
  std::array<double, 2> top{};
  ASSERT_FALSE(r.water_table.empty());
  for (const auto& line : r.water_table) {
    for (const auto& x : line) {
      if (x[1] > top[1]) top = x;
    }
  }
  EXPECT_NEAR(top[0], 4.1, 0.2);
  EXPECT_NEAR(top[1], 4.55, 0.1);
  EXPECT_NEAR(r.outflow - r.discharges[0].inflow - r.discharges[1].inflow, 2.5e-5, 1e-14);
}

TEST(SeepagePublished, EarthDamOnRock) {
  // Bowles: base 100 m, crest 10 m at 20 m, slopes 1:2.5 and 1:2, reservoir 18.5 m, k = 6.67e-6 m/s: 1.10 to 1.28e-3
  // m³/min by flow nets, 1.37 and 1.378e-3 by two programs.
  mesh::Plan plan;
  plan.box_max = {100, 21};
  plan.size = 1.0;
  plan.polygons = {{"soil", {{0, 0}, {100, 0}, {60, 20}, {50, 20}}}};
  plan.lines = {{"upstream", {{0, 0}, {50, 20}}}, {"downstream", {{60, 20}, {100, 0}}}};
  const auto mesh = mesh::generate<2>(plan);
  auto soil = make_soil<2>(6.67e-6);
  double last = 1.4e-3;  // the lower the fringe, the less flows above the water table
  for (double fringe : {4.0, 2.0, 1.0}) {
    soil.relative = make_ramp(fringe);
    SeepageModel<2> model{&mesh, {soil}, {}};
    model.boundaries = {make_condition(mesh, "upstream", HydraulicKind::reservoir, 18.5),
                        make_condition(mesh, "downstream", HydraulicKind::seepage_face)};
    const auto r = fem::solve_steady_seepage(model);
    EXPECT_LT(relative_balance(r), 1e-10);
    EXPECT_LT(r.outflow * 60, last);
    EXPECT_GT(r.outflow * 60, 1.28e-3);
    last = r.outflow * 60;
  }
}

}  // namespace
}  // namespace talus
