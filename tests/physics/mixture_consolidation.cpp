// SPDX-License-Identifier: MIT
// Consolidation in the plain step of the Darcy formulation, with the bulk modulus of real water and without mass
// scaling.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "physics/wet_columns.hpp"
#include "reference/plain_mixture.hpp"
#include "reference/two_phase_bodies.hpp"

namespace talus::reference {
namespace {

using std::numbers::pi;

constexpr double load = 1e4, modulus = 1e7 * 0.7 / 0.52;

/// Largest step of the drained wave [s].
double drained_step(const WetBody<2>& body) {
  return smallest_altitude(body.mesh) / std::sqrt(modulus / (0.6 * 2650 + 0.4 * 1000));
}

struct Consolidation {
  double early = 0, later = 0;  ///< largest error of the nodes' isochrones, at T = 0.2 and after [p0]
};

/// A column of 0.1 m under 10 kPa from its undrained state to T = 0.6, with water of 2.15 GPa and no mass scaling.
Consolidation consolidate(int cells, double jitter) {
  const double height = 0.1, h = height / cells, n = 0.4;
  const Soil soil = make_table_soil(3e-12);
  const double storage = 1 / modulus + n / soil.water.bulk_modulus;
  const double c_v = soil.water.conductivity / (1000 * 9.81 * storage);
  DarcyBody<2> body{make_column<2>(cells, h, soil, n, jitter)};
  body.tractions = face_areas(body.mesh, 1, height);
  for (Vector<2>& t : body.tractions) t *= -load;
  for (WetPoint<2>& point : body.points) {
    point.pressure = -load / modulus / storage;
    const double strain = point.pressure * n / soil.water.bulk_modulus;
    point.sigma = Vector3(3.0 / 7, 1, 3.0 / 7).asDiagonal() * (strain * modulus);
    point.water_mass = pore_volume(body, point) * water_density(soil.water, point.pressure);
  }
  DarcySettings settings;
  settings.time_step = 0.9 * drained_step(body);
  settings.damping = 0.02;
  Consolidation result;
  for (int part = 1; part <= 3; ++part) {
    while (body.steps * settings.time_step < 0.2 * part * height * height / c_v) step<2>(body, settings);
    const double t = body.steps * settings.time_step;
    double& largest = part == 1 ? result.early : result.later;
    for (std::size_t i = 0; i < body.pressure.size(); ++i) {
      const double exact = isochrone(1 - body.mesh.nodes[i][1] / height, t * c_v / (height * height));
      largest = std::max(largest, std::abs(-body.pressure[i] / load - exact));
    }
  }
  std::printf("mixture, %d squares, %.3g s a step: error %.5f p0 at T = 0.2, %.5f after\n", cells, settings.time_step,
              result.early, result.later);
  return result;
}

TEST(MixtureConsolidation, FollowsTerzaghiWithRealWaterAtTheStepOfTheDrainedWave) {
  const Consolidation coarse = consolidate(5, 0), fine = consolidate(10, 0), jittered = consolidate(10, 0.2);
  EXPECT_LT(coarse.early, 0.01);
  EXPECT_LT(fine.early, 0.003);
  EXPECT_LT(fine.later, 0.002);
  EXPECT_LT(jittered.early, 0.003);
}

/// The undrained wave would need a step twenty times smaller.
TEST(MixtureConsolidation, IsStableForAnyConductivityAndCarriesASuddenLoadByTheWater) {
  for (const double permeability : {1e-8, 1e-12, 1e-16}) {
    DarcyBody<2> body{make_column<2>(8, 0.1, make_table_soil(permeability), 0.4, 0.2)};
    body.surface.assign(body.mesh.nodes.size(), {.kind = SurfaceKind::closed});
    body.tractions = face_areas(body.mesh, 1, 0.8);
    for (Vector<2>& t : body.tractions) t *= -load;
    DarcySettings settings;
    settings.time_step = 0.9 * drained_step(body);
    settings.damping = 0.3;
    for (int n = 0; n < 2000; ++n) step<2>(body, settings);
    const double stiff = 2.15e9 / 0.4;
    for (const WetPoint<2>& point : body.points) {
      EXPECT_NEAR(point.pressure, -load * stiff / (stiff + modulus), 1e-3 * load) << permeability;
      EXPECT_NEAR(point.sigma(1, 1), -load * modulus / (stiff + modulus), 1e-3 * load) << permeability;
    }
  }
}

}  // namespace
}  // namespace talus::reference
