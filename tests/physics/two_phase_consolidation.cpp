// SPDX-License-Identifier: MIT
// Terzaghi's consolidation (2.6.2) in the plain two-velocity step, and its two limits: drained and undrained
// compression.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "physics/wet_columns.hpp"
#include "reference/two_phase_bodies.hpp"

namespace talus::reference {
namespace {

using std::numbers::pi;

/// (2.105): degree of consolidation.
double degree(double factor) {
  double sum = 0;
  for (int k = 1; k <= 200; ++k) {
    const double m = (2 * k - 1) * pi / 2;
    sum += 2 / (m * m) * std::exp(-m * m * factor);
  }
  return 1 - sum;
}

struct Consolidation {
  double time_step = 0;
  double largest_error_02 = 0;  ///< of the isochrone T = 0.2 [p0]
  double largest_error = 0;     ///< of the later isochrones, every 0.2 [p0]
  double degree_error = 0;      ///< largest error of U, from the settlement
};

/// A column of height H in `cells` squares under 10 kPa. `beta` scales the inertia.
Consolidation consolidate(double height, int cells, WetSettings settings, double beta, int parts = 5) {
  const double h = height / cells, load = 1e4;
  const Soil soil = make_table_soil(1.0214e-13);
  const double modulus = 1e7 * 0.7 / 0.52, n = 0.4;
  const CoupledSoil limits =
      CoupledSoil::saturated(modulus, n, soil.water.bulk_modulus, soil.grain_density, soil.water.conductivity);
  const double storage = 1 / modulus + n / soil.water.bulk_modulus;
  const double c_v = soil.water.conductivity / (1000 * 9.81 * storage);
  WetBody<2> body = make_column<2>(cells, h, soil, n);
  body.tractions = face_areas(body.mesh, 1, height);
  for (Vector<2>& t : body.tractions) t *= -load;
  // The load is there from the start: the soil begins in its undrained state, not with the wave that leads to it.
  for (WetPoint<2>& point : body.points) {
    point.pressure = -load / modulus / storage;
    const double strain = point.pressure * n / soil.water.bulk_modulus;  // undrained: Δp = K_w/n ε
    point.sigma = Vector3(3.0 / 7, 1, 3.0 / 7).asDiagonal() * (strain * modulus);
    point.strain(1, 1) = strain;
    const double pores = pore_volume(body, point);
    point.water_mass = pores * water_density(soil.water, point.pressure);
  }
  settings.mass_scaling = beta;
  settings.time_step = 0.9 * critical_step(limits, smallest_altitude(body.mesh), beta, settings.drag);
  Consolidation result{.time_step = settings.time_step};
  double t = 0;
  for (int part = 1; part <= parts; ++part) {
    const double factor = 0.2 * part;
    for (; t < factor * height * height / c_v; t += settings.time_step) step(body, settings);
    const double now = t * c_v / (height * height);
    double settlement = 0;
    for (const WetCell& cell : body.cells) {  // the pressure of a full element is that of its middle
      double y = 0;
      for (std::size_t p : cell.points) y += body.points[p].x[1] / static_cast<double>(cell.points.size());
      const double error = std::abs(-body.points[cell.points[0]].pressure / load - isochrone(1 - y / height, now));
      double& largest = part == 1 ? result.largest_error_02 : result.largest_error;
      largest = std::max(largest, error);
    }
    for (const WetPoint<2>& point : body.points)
      settlement -= point.strain(1, 1) * point.volume / (h * height) * height;
    const double u = settlement / (load * height / modulus);
    result.degree_error = std::max(result.degree_error, std::abs(u - degree(now)));
  }
  std::printf("Terzaghi H %.2f m, %d squares, dt %.3e s: error %.4f p0 at T 0.2, %.4f after, U %.4f\n", height, cells,
              result.time_step, result.largest_error_02, result.largest_error, result.degree_error);
  return result;
}

TEST(TwoPhaseConsolidation, FollowsTerzaghiWithExplicitDragAndImplicitDragAtTenTimesItsStep) {
  // A tenth of the height takes a hundredth of the time; the steps shrink only tenfold.
  const Consolidation as_source =
      consolidate(0.1, 10, {.drag = Drag::explicit_as_source, .damping = 0.01, .water_damping = 0.01}, 100, 3);
  const Consolidation implicit = consolidate(0.1, 10, {.damping = 0.01}, 5500, 3);
  EXPECT_GT(implicit.time_step, 10 * as_source.time_step);
  for (const Consolidation& c : {as_source, implicit}) {
    EXPECT_LT(c.largest_error_02, 0.03);
    EXPECT_LT(c.largest_error, 0.02);  // ten squares: half of it is the mesh, see the next test
    EXPECT_LT(c.degree_error, 0.005);
  }
}

TEST(TwoPhaseConsolidation, ComesCloserToTerzaghiOnAFinerMesh) {
  const Consolidation implicit = consolidate(0.1, 20, {.damping = 0.01}, 5500);
  EXPECT_LT(implicit.largest_error_02, 0.03);
  EXPECT_LT(implicit.largest_error, 0.01);
  EXPECT_LT(implicit.degree_error, 0.002);
}

/// A column of four squares under 10 kPa, brought to rest by damping; `drained` opens its top; else a skin
/// closes it that settles with the soil.
WetBody<2> compress(bool drained) {
  Soil soil = make_table_soil(drained ? 1e-8 : 1e-11);
  soil.water.bulk_modulus = 2.15e7;  // 100 times too soft, so that its compression shows
  WetBody<2> body = make_column<2>(4, 0.25, soil, 0.4);
  if (!drained) body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::closed});
  body.tractions = face_areas(body.mesh, 1, 1.0);
  for (Vector<2>& t : body.tractions) t *= -1e4;
  const CoupledSoil limits =
      CoupledSoil::saturated(1e7 * 0.7 / 0.52, 0.4, soil.water.bulk_modulus, 2650, soil.water.conductivity);
  const WetSettings settings{
      .time_step = 0.9 * critical_step(limits, smallest_altitude(body.mesh), 1, Drag::implicit_at_nodes),
      .damping = 0.5,
      .water_damping = 0.5,
      .damped_force = DampedForce::net};
  for (int n = 0; n < 6000; ++n) step(body, settings);
  return body;
}

TEST(TwoPhaseConsolidation, DrainedCompressionIsCarriedByTheSkeletonAndUndrainedByBoth) {
  const double modulus = 1e7 * 0.7 / 0.52, stiff_water = 2.15e7 / 0.4;
  for (const bool drained : {true, false}) {
    const WetBody<2> body = compress(drained);
    const double sum = modulus + (drained ? 0 : stiff_water);
    for (const WetPoint<2>& point : body.points) {
      // 1e-3: the strains are that large, and affect both the porosity and the mesh of the tractions
      EXPECT_NEAR(point.sigma(1, 1), -1e4 * modulus / sum, 1e4 * 2e-3);
      EXPECT_NEAR(point.pressure, drained ? 0 : -1e4 * stiff_water / sum, 1e4 * 2e-3);
      EXPECT_NEAR(point.strain(1, 1), -1e4 / sum, 2e-3 * 1e4 / sum);
    }
  }
}

TEST(TwoPhaseConsolidation, DISABLED_FullColumn) {
  const Consolidation c = consolidate(1.0, 50, {.damping = 0.01}, 1e4);
  EXPECT_LT(c.largest_error_02, 0.03);
  EXPECT_LT(c.largest_error, 0.01);
  EXPECT_LT(c.degree_error, 0.005);
}

}  // namespace
}  // namespace talus::reference
