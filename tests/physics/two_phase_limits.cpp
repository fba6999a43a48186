// SPDX-License-Identifier: MIT
// Critical time steps of the two-velocity formulation against the printed values of the source and against the plain
// step, which is stable just below the exact limit and unstable just above it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/plain_two_phase_limits.hpp"

namespace talus::reference {
namespace {

const double modulus = 1e7 * 0.7 / (1.3 * 0.4);
double conductivity(double permeability) {
  return 1000 * 9.81 / 1.002e-3 * permeability;
}
CoupledSoil wave_soil() {
  return CoupledSoil::saturated(modulus, 0.4, 2.15e9, 2650, conductivity(1.0214e-12));
}
CoupledSoil terzaghi_soil() {
  return CoupledSoil::saturated(modulus, 0.4, 2.15e9, 2650, conductivity(1.0214e-13));
}

TEST(TwoPhaseLimits, BoundOfTheSourceGivesItsPrintedSteps) {
  const double diagonal = std::sqrt(0.5);  // altitude of half a unit square
  EXPECT_NEAR(critical_step(wave_soil(), 1e-3 * diagonal, 1, Drag::explicit_as_source), 3.674e-7, 0.003 * 3.674e-7);
  EXPECT_NEAR(critical_step(terzaghi_soil(), 0.02 * diagonal, 40, Drag::explicit_as_source), 1.4789e-5,
              0.003 * 1.4789e-5);
  EXPECT_NEAR(exact_critical_step(wave_soil(), 1e-3 * diagonal, 1, Drag::explicit_as_source), 3.813e-7, 0.001e-7);
  EXPECT_NEAR(exact_critical_step(terzaghi_soil(), 0.02 * diagonal, 40, Drag::explicit_as_source), 1.591e-5, 0.001e-5);
  EXPECT_NEAR(wave_soil().undrained_wave_speed(), 1645.5, 0.05);
}

TEST(TwoPhaseLimits, ExplicitDragBoundsTheStepOfTightSoilsAndImplicitDragDoesNot) {
  CoupledSoil soil = terzaghi_soil();
  soil.conductivity = 1e-9;
  const double length = 0.02, rho = soil.mass().sum();
  const double drag_only = 2 * 0.6 * 2650 * soil.conductivity / (0.4 * rho * 9.81);
  EXPECT_NEAR(critical_step(soil, length, 1, Drag::explicit_as_source) / drag_only, 1, 1e-3);
  EXPECT_NEAR(critical_step(soil, length, 10, Drag::explicit_as_source) / drag_only, 10, 1e-2);
  // Implicit drag makes water and solid move together: the wave is the undrained one.
  EXPECT_NEAR(exact_critical_step(soil, length, 1, Drag::implicit_at_nodes) * soil.undrained_wave_speed() / length, 1,
              1e-5);
}

TEST(TwoPhaseLimits, ImplicitLimitGrowsWithTheDragFromTheFreeWaveToTheUndrainedOne) {
  CoupledSoil soil = terzaghi_soil();
  const double length = 0.02, undrained = length / soil.undrained_wave_speed();
  const double bound = critical_step(soil, length, 1, Drag::implicit_at_nodes);
  double last = 0;
  for (double k = 1e4; k > 1e-9; k /= 10) {
    soil.conductivity = k;
    const double exact = exact_critical_step(soil, length, 1, Drag::implicit_at_nodes);
    EXPECT_GE(exact, last);
    EXPECT_GE(exact, bound * (1 - 1e-9));
    EXPECT_LE(exact, undrained * (1 + 1e-9));
    last = exact;
  }
  soil.conductivity = 1e6;  // hardly any drag: bound and limit are the same number
  EXPECT_NEAR(exact_critical_step(soil, length, 1, Drag::implicit_at_nodes) / bound, 1, 1e-6);
}

/// Largest |eigenvalue| of one step of the 1-D scheme at the shortest wave, λ = 4/L²: velocities, then strains.
double amplification(const CoupledSoil& soil, double length, double dt, Drag drag) {
  const Eigen::Matrix2d k = soil.stiffness() * 4 / (length * length), mass = soil.mass().asDiagonal();
  const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
  Eigen::Matrix2d c;
  c << 1, -1, -1, 1;
  c *= soil.drag() * dt;
  Eigen::Matrix2d from_v, from_u;  // v' = from_v v + from_u u, u' = u + Δt v'
  if (drag == Drag::implicit_at_nodes) {
    const Eigen::Matrix2d inverse = (mass + c).inverse();
    from_v = inverse * mass, from_u = -dt * inverse * k;
  } else {
    from_v = one - mass.inverse() * c, from_u = -dt * mass.inverse() * k;
  }
  Eigen::Matrix4d step;
  step << from_v, from_u, dt * from_v, one + dt * from_u;
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

TEST(TwoPhaseLimits, ExactLimitIsWhereTheOneDimensionalSchemeBeginsToGrow) {
  for (const Drag drag : {Drag::implicit_at_nodes, Drag::explicit_as_source})
    for (const CoupledSoil& soil : {wave_soil(), terzaghi_soil()})
      for (const double length : {1e-3, 0.02, 0.5}) {
        const double limit = exact_critical_step(soil, length, 1, drag);
        EXPECT_LE(amplification(soil, length, 0.999 * limit, drag), 1 + 1e-9);
        EXPECT_GT(amplification(soil, length, 1.001 * limit, drag), 1 + 1e-4);
        EXPECT_LE(critical_step(soil, length, 1, drag), limit * (1 + 1e-9));
      }
}

/// Largest velocity after `steps` of the 1-D scheme with explicit drag, with the fraction α of the net force as damping
/// of both phases (T14.10).
double march_damped(const CoupledSoil& soil, double length, double dt, double alpha, int steps) {
  const Eigen::Matrix2d k = soil.stiffness() * 4 / (length * length);
  Eigen::Matrix2d c;
  c << 1, -1, -1, 1;
  c *= soil.drag();
  Eigen::Vector2d u(0, 0), v(1, -0.5);
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector2d force = -k * u - c * v;
    for (int phase = 0; phase < 2; ++phase)
      v[phase] += dt / soil.mass()[phase] * (force[phase] - alpha * std::abs(force[phase]) * (v[phase] > 0 ? 1 : -1));
    u += dt * v;
    if (!(v.norm() < 1e6)) break;
  }
  return v.norm();
}

/// Net damping increases explicit drag by its fraction. The critical step without it is then far too long.
TEST(TwoPhaseLimits, NetDampingShortensTheStepOfExplicitDrag) {
  for (const double alpha : {0.2, 0.5, 0.75, 0.9})
    for (const double conductivity : {1e-5, 1e-9}) {
      CoupledSoil soil = terzaghi_soil();
      soil.conductivity = conductivity;
      const double length = 0.02, dt = critical_step(soil, length, 1 / (1 + alpha), Drag::explicit_as_source);
      EXPECT_LT(march_damped(soil, length, 0.98 * dt, alpha, 3000), 1) << alpha << ", " << conductivity;
      if (conductivity == 1e-9) {
        EXPECT_GT(march_damped(soil, length, 1.02 * dt, alpha, 3000), 1e3) << alpha;
      }
    }
}

TEST(TwoPhaseLimits, UnsaturatedSoilHasTheStorageOfItsRetentionCurve) {
  // S = 0.5 and dS/dp = −1e-5/Pa: the pressure response is 4 to 5 orders of magnitude softer than in saturated soil.
  CoupledSoil soil = terzaghi_soil();
  soil.saturation = 0.5, soil.storage = 0.4 * (0.5 / 2.15e9 + 1e-5);
  const double stiffness = 0.25 / soil.storage;
  EXPECT_NEAR(stiffness, 0.25 / 4e-6, 10);
  EXPECT_NEAR(soil.undrained_wave_speed(), std::sqrt((modulus + stiffness) / (0.6 * 2650 + 0.2 * 1000)), 1e-9);
  EXPECT_GT(critical_step(soil, 0.02, 1, Drag::implicit_at_nodes),
            10 * critical_step(terzaghi_soil(), 0.02, 1, Drag::implicit_at_nodes));
}

}  // namespace
}  // namespace talus::reference
