// SPDX-License-Identifier: MIT
// Water at rest in the plain two-velocity step: a saturated body remains at rest in every mode, and suction above the
// water table persists under a surface without inflow.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "physics/gravity.hpp"
#include "reference/two_phase_bodies.hpp"

namespace talus::reference {
namespace {

template <int D>
double fastest_node(const WetBody<D>& body) {
  double fastest = 0;
  for (const WetNode<D>& node : body.nodes) fastest = std::max({fastest, node.v.norm(), node.w.norm()});
  return fastest;
}

/// A jittered cube of 1 m, water standing at its top.
template <int D>
WetBody<D> make_hydrostatic() {
  std::array<int, D> cells{};
  cells.fill(D == 2 ? 6 : 3);
  Soil soil = make_table_soil();
  soil.water.bulk_modulus = 2.15e9;
  WetBody<D> body = make_wet_body(make_box<D>(cells, cube<D>(1.0)), soil);
  fix_wet_box(body, cube<D>(1.0));
  fill_wet(
      body, 0.4, 0, [](const Vector<D>&) { return true; }, [](const Vector<D>& x) { return -gamma_w * (1 - x[1]); });
  for (WetPoint<D>& point : body.points) {
    const double depth = -point.pressure / gamma_w, buoyant = 0.6 * (2650 - 1000) * g;
    point.sigma = -buoyant * depth * Vector3(0.5, 1, 0.5).asDiagonal().toDenseMatrix();
  }
  body.gravity[1] = -g;
  return body;
}

template <int D>
void expect_still(const WetSettings& settings) {
  WetBody<D> body = make_hydrostatic<D>();
  const std::vector<WetPoint<D>> start = body.points;
  for (int n = 0; n < 300; ++n) step(body, settings);
  // Water at depth is denser by p/K_w = 5e-6, which the stress above ignores; all else is round-off.
  for (std::size_t p = 0; p < start.size(); ++p) {
    EXPECT_NEAR(body.points[p].pressure, start[p].pressure, 0.2);
    EXPECT_LT((body.points[p].sigma - start[p].sigma).norm(), 0.2);
    EXPECT_LT((body.points[p].x - start[p].x).norm(), 1e-8);
  }
  EXPECT_LT(fastest_node(body), 1e-6);
}

TEST(TwoPhaseEquilibrium, SaturatedColumnStaysStillInEveryMode) {
  const CoupledSoil soil = CoupledSoil::saturated(1e7 * 0.7 / 0.52, 0.4, 2.15e9, 2650, 1e-5);
  const double dt2 =
      0.5 * critical_step(soil, smallest_altitude(make_hydrostatic<2>().mesh), 1, Drag::explicit_as_source);
  const double dt3 =
      0.5 * critical_step(soil, smallest_altitude(make_hydrostatic<3>().mesh), 1, Drag::explicit_as_source);
  for (const Drag drag : {Drag::implicit_at_nodes, Drag::explicit_as_source})
    for (const bool mixed : {true, false})
      for (const Smoothing smoothing : {Smoothing::none, Smoothing::strain, Smoothing::stable}) {
        expect_still<2>({.time_step = dt2,
                         .drag = drag,
                         .damping = 0.1,
                         .mixed = mixed,
                         .smoothing = smoothing,
                         .smooth_pressure = smoothing == Smoothing::strain});
        if (smoothing != Smoothing::stable)
          expect_still<3>({.time_step = dt3, .drag = drag, .mixed = mixed, .smoothing = smoothing});
      }
}

/// A column of 2 m in squares of 0.1 m with the water table at its middle, and hydrostatic suction above.
WetBody<2> make_suction_column(SurfaceKind top) {
  const Soil soil = make_retaining_soil();
  WetBody<2> body = make_column<2>(20, 0.1, soil, 0.4);
  body.points.clear();
  fill_wet(
      body, 0.4, 0, [](const Vector<2>&) { return true; }, [](const Vector<2>& x) { return gamma_w * (x[1] - 1); });
  body.surface.assign(body.mesh.nodes.size(), {.kind = top});
  body.gravity[1] = -g;
  for (WetPoint<2>& point : body.points) {
    const double y = 1 + point.pressure / gamma_w;
    double weight = 0;  // of what is above, by Simpson's rule
    const auto unit_weight = [&](double at_y) {
      return (0.6 * 2650 + 0.4 * 1000 * soil.water.saturation(gamma_w * (at_y - 1))) * g;
    };
    const int parts = 200;
    for (int i = 0; i < parts; ++i) {
      const double a = y + (2 - y) * i / parts, b = y + (2 - y) * (i + 1) / parts;
      weight += (b - a) / 6 * (unit_weight(a) + 4 * unit_weight((a + b) / 2) + unit_weight(b));
    }
    const double vertical = -weight - soil.water.saturation(point.pressure) * point.pressure;
    point.sigma = vertical * Vector3(3.0 / 7, 1, 3.0 / 7).asDiagonal().toDenseMatrix();
  }
  return body;
}

TEST(TwoPhaseEquilibrium, SuctionAboveTheWaterTableIsInEquilibriumUnderAClosedSurfaceOnly) {
  for (const SurfaceKind top : {SurfaceKind::seepage, SurfaceKind::open}) {
    WetBody<2> body = make_suction_column(top);
    const std::vector<WetPoint<2>> start = body.points;
    const CoupledSoil limits = CoupledSoil::saturated(1e7 * 0.7 / 0.52, 0.4, 2.15e9, 2650, 1e-3);
    const WetSettings settings{
        .time_step = 0.9 * critical_step(limits, smallest_altitude(body.mesh), 1000, Drag::implicit_at_nodes),
        .damping = 0.3,
        .mass_scaling = 1000};
    double water = 0;
    for (const WetPoint<2>& point : start) water += point.water_mass;
    for (double t = 0; t < 5; t += settings.time_step) step(body, settings);
    double largest = 0;
    for (std::size_t p = 0; p < start.size(); ++p)
      largest = std::max(largest, std::abs(body.points[p].pressure - start[p].pressure));
    const double gone = (body.budget.left + body.budget.entered) / water;
    std::printf("suction column: pressure changes by %.3g Pa, %.3g of the water passes the surface\n", largest, gone);
    if (top == SurfaceKind::seepage) {
      EXPECT_LT(largest, 0.005 * gamma_w);  // of 9.8 kPa at the top
      EXPECT_LT(gone, 1e-5);
    } else {
      EXPECT_GT(largest, 0.2 * gamma_w);  // a free surface takes up water: the test above can fail
      EXPECT_GT(gone, 1e-2);
    }
  }
}

}  // namespace
}  // namespace talus::reference
