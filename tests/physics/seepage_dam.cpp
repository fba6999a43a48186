// SPDX-License-Identifier: MIT
// Free surfaces: the rectangular dam against Dupuit's discharge and a variational solution, and an earth dam against
// published pressures.

#include <gtest/gtest.h>

#include "mesh/generate.hpp"
#include "mesh/locate.hpp"
#include "physics/seepage_box.hpp"

namespace talus {
namespace {

using namespace support;

/// Height of the water table at x by the polylines; the largest where there are several.
double find_height(const std::vector<std::vector<std::array<double, 2>>>& lines, double x) {
  double y = -1e30;
  for (const auto& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto &a = line[i - 1], &b = line[i];
      if ((a[0] - x) * (b[0] - x) <= 0 && a[0] != b[0])
        y = std::max(y, a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]));
    }
  }
  return y;
}

/// A rectangular dam of width l between h1 and h2 [m], as high as h1, whose k_r falls to 1e-3 over `fringe` [m].
struct Dam {
  double h1, h2, l;
  mesh::Mesh<2> mesh;
  fem::SeepageResult<2> result;
  double capillary_discharge = 0;  ///< (1/L) ∫ ∫ k_r ds dy over the outer face above its wet part, over k [m²]

  Dam(double h1_, double h2_, double l_, int n, double fringe) : h1(h1_), h2(h2_), l(l_) {
    const double h = h1 / n;
    mesh = make_soil_box<2>({static_cast<int>(std::lround(l / h)), n}, {l, h1});
    auto soil = make_soil<2>(1.0);
    soil.retention = material::LinearRetention::from_scale(0.1, 1, fringe * gamma_w);
    soil.relative =
        material::make_conductivity_table({{0, 1}, {fringe * gamma_w, 1e-3}}, material::Interpolation::linear, false);
    SeepageModel<2> model{&mesh, {soil}, {}};
    model.boundaries = {make_condition(mesh, "left", HydraulicKind::total_head, h1),
                        make_condition(mesh, "right", HydraulicKind::reservoir, h2)};
    result = fem::solve_steady_seepage(model);
    // Kirchhoff's potential of the suction along the outer face, by the trapezoidal rule
    for (const auto& side : mesh.sides.at("right")) {
      double mean = 0;
      for (int node : side) {
        const double s = std::max(0.0, result.pressure[static_cast<std::size_t>(node)] / gamma_w);
        const double r = std::min(s, fringe);
        mean += 0.5 * (r - 0.5 * r * r / fringe * (1 - 1e-3) + 1e-3 * (s - r));
      }
      const double dy =
          mesh.nodes[static_cast<std::size_t>(side[0])][1] - mesh.nodes[static_cast<std::size_t>(side[1])][1];
      capillary_discharge += mean * std::abs(dy) / l;
    }
  }
};

TEST(SeepageDam, RectangularDamHasDupuitsDischargeExitPointAndFreeSurface) {
  // q = k (h1² - h2²)/(2L) holds exactly with a seepage face. Exit points and free surface: variational inequality of
  // Baiocchi, computed independently on 960 cells.
  struct Published {
    double h1, h2, l, exit;
    std::vector<double> surface;  // at x/L = 0.1 … 0.9
  };
  const std::vector<Published> dams = {
      {24, 4, 16, 12.71, {23.551, 22.94, 22.213, 21.377, 20.43, 19.36, 18.146, 16.751, 15.081}},
      {10, 2, 10, 3.94, {9.739, 9.393, 8.99, 8.535, 8.025, 7.458, 6.821, 6.092, 5.219}},
      {1, 0, 1, 0.368, {}}};
  for (const auto& p : dams) {
    const double dupuit = (p.h1 * p.h1 - p.h2 * p.h2) / (2 * p.l);
    for (int n : {24, 48}) {
      const Dam dam(p.h1, p.h2, p.l, n, 1.5 * p.h1 / n);
      const auto& r = dam.result;
      const double h = p.h1 / n;
      EXPECT_LT(relative_balance(r), 1e-10);
      // Dupuit's formula plus what flows above the water table, which vanishes with the fringe
      EXPECT_NEAR(r.inflow / (dupuit + dam.capillary_discharge), 1, 3e-4);
      EXPECT_NEAR(r.inflow / dupuit, 1, 1.0 / n);
      EXPECT_EQ(r.undecided, 0);
      ASSERT_EQ(r.exits.size(), 1u);
      EXPECT_GT(r.exits[0].highest[1], p.exit - h);
      EXPECT_LT(r.exits[0].highest[1], p.exit + 2 * h);  // a mesh and a fringe of 1.5 h above the exact one
      for (std::size_t i = 0; i < p.surface.size(); ++i) {
        const double x = 0.1 * static_cast<double>(i + 1) * p.l;
        EXPECT_NEAR(find_height(r.water_table, x), p.surface[i], 0.4 * h) << x;
      }
    }
  }
}

TEST(SeepageDam, ThickDamIsThePlaneOne) {
  const double h1 = 4, l = 3, depth = 1, fringe = 0.5;
  auto mesh = make_soil_box<3>({9, 12, 3}, {l, h1, depth});
  auto soil = make_soil<3>(1.0);
  soil.relative =
      material::make_conductivity_table({{0, 1}, {fringe * gamma_w, 1e-3}}, material::Interpolation::linear, false);
  SeepageModel<3> model{&mesh, {soil}, {}};
  model.boundaries = {make_condition(mesh, "left", HydraulicKind::total_head, h1),
                      make_condition(mesh, "right", HydraulicKind::reservoir, 1)};
  const auto r = fem::solve_steady_seepage(model);
  EXPECT_LT(relative_balance(r), 1e-10);
  const Dam plane(h1, 1, l, 12, fringe);
  EXPECT_NEAR(r.inflow / (depth * plane.result.inflow), 1, 0.01);
  ASSERT_EQ(r.exits.size(), 1u);
  EXPECT_NEAR(r.exits[0].highest[1], plane.result.exits[0].highest[1], 0.4);
}

TEST(SeepageDam, FlowUnderARisingLevelEndsInTheSteadyOne) {
  // Groundwater behind the soil rises past the nodes of its border, each of which jumps to the level that reaches it.
  constexpr double day = 86400, low = 1, high = 8;
  const auto mesh = make_soil_box<2>({8, 10}, {16, 10});
  auto soil = make_soil<2>(1e-5);
  soil.retention = material::VanGenuchten{0.1, 1, 10e3, 0.5};
  for (const double rise : {0.3, 1.5}) {
    SeepageModel<2> model{&mesh, {soil}, {}};
    model.boundaries = {make_condition(mesh, "left", HydraulicKind::reservoir, low),
                        make_condition(mesh, "right", HydraulicKind::reservoir, 3)};
    const auto before = fem::solve_steady_seepage(model);
    model.boundaries[0].value = high;
    const auto steady = fem::solve_steady_seepage(model);
    model.boundaries[0].history = {{0, low}, {rise * day, high}};
    fem::SeepageSchedule schedule;
    schedule.outputs = {rise * day, 400 * day};
    schedule.head_tolerance = 0.01;
    const auto history = fem::solve_transient_seepage(model, before.head, schedule);
    const auto& end = history.states.back();
    EXPECT_NEAR(end.inflow / steady.inflow, 1, 1e-3) << rise;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) EXPECT_NEAR(end.head[i], steady.head[i], 0.01) << rise;
    const auto& v = history.volumes.back();
    EXPECT_NEAR(v[0].inflow + v[1].inflow - v[0].outflow - v[1].outflow, history.stored.back(), 1e-6 * v[0].inflow);
  }
}

TEST(SeepageDam, EarthDamHasThePublishedPressuresAndDischarge) {
  // Fredlund and Rahardjo's dam: base 52 m, crest 4 m, height 12 m, 1:2 slopes, reservoir at 10 m; k over suction as a
  // table. Pore pressure heads [m] on x = 26 m, read from published contours to 0.1 m, and discharges of a second
  // program.
  mesh::Plan plan;
  plan.box_max = {52, 13};
  plan.size = 0.7;
  plan.polygons = {{"soil", {{0, 0}, {52, 0}, {28, 12}, {24, 12}}}};
  plan.lines = {{"upstream", {{0, 0}, {24, 12}}}, {"downstream", {{28, 12}, {52, 0}}}, {"drain", {{40, 0}, {52, 0}}}};
  const auto mesh = mesh::generate<2>(plan);
  const std::vector<std::array<double, 2>> k = {{0, 1}, {gamma_w, 1}, {10 * gamma_w, 1e-3}, {15 * gamma_w, 1e-4}};
  struct Case {
    const char* name;
    bool drain;
    double horizontal;  // k_x / k_y
    double discharge;
    std::vector<double> heads;  // at y = 0, 2, 4, 6, 8
  };
  for (const Case& c : {Case{"drain", true, 1, 2.808e-7, {7.15, 5.15, 3.25, 1.3, -0.6}},
                        Case{"anisotropic", true, 9, 1.692e-6, {6.5, 4.7, 3.2, 1.85, 0.4}},
                        Case{"seepage face", false, 1, 1.777e-7, {8.4, 6.4, 4.5, 2.5, 0.55}}}) {
    auto soil = make_soil<2>(1e-7);
    soil.conductivity[0] *= c.horizontal;
    soil.relative = material::make_conductivity_table(k, material::Interpolation::linear);
    SeepageModel<2> model{&mesh, {soil}, {}};
    model.boundaries = {make_condition(mesh, "upstream", HydraulicKind::reservoir, 10),
                        make_condition(mesh, "downstream", HydraulicKind::seepage_face)};
    if (c.drain) model.boundaries.push_back(make_condition(mesh, "drain", HydraulicKind::pressure, 0));
    const auto r = fem::solve_steady_seepage(model);
    EXPECT_LT(relative_balance(r), 1e-10) << c.name;
    for (std::size_t i = 0; i < 5; ++i) {
      const std::array<double, 2> x{26, 2.0 * static_cast<double>(i) + (i == 0 ? 1e-9 : 0)};
      const auto e = static_cast<std::size_t>(mesh::find_element(mesh, x));
      const auto xi = mesh::to_local(mesh, static_cast<int>(e), x);
      double p = r.pressure[static_cast<std::size_t>(mesh.elements[e][0])] * (1 - xi[0] - xi[1]);
      for (std::size_t n = 0; n < 2; ++n) p += r.pressure[static_cast<std::size_t>(mesh.elements[e][n + 1])] * xi[n];
      EXPECT_NEAR(-p / gamma_w, c.heads[i], 0.2) << c.name << " at " << x[1];
    }
    EXPECT_NEAR(r.outflow / c.discharge, 1, 0.05) << c.name;
  }
}

}  // namespace
}  // namespace talus
