// SPDX-License-Identifier: MIT
// Element tests against the closed-form strength of Mohr–Coulomb soil and the moduli of elastic soil.

#include "base/error.hpp"
#include "support/point_soils.hpp"

namespace talus::laboratory {
namespace {

using input::PointControl;
using input::PointTestKind;
using support::make_cell_test;
using support::make_elastic;
using support::make_frictional;
using support::make_ring_test;

constexpr double degree = M_PI / 180;

/// σ1 = N σ3 + 2c√N at failure.
double find_stress_ratio(double friction) {
  return (1 + std::sin(friction)) / (1 - std::sin(friction));
}

TEST(PointStrength, TriaxialCompressionAndExtensionEndOnMohrsCircle) {
  for (const double friction : {20 * degree, 35 * degree}) {
    const double c = 8e3, cell = 100e3, n = find_stress_ratio(friction);
    const input::Material soil = make_frictional(c, friction, 5 * degree);
    input::PointTest test = make_cell_test(PointTestKind::drained_triaxial, cell);
    test.axial_strain = {0.06};
    test.steps = 300;
    PointCurve curve = run_point_test(soil, test);
    const double strongest = n * cell + 2 * c * std::sqrt(n);
    EXPECT_NEAR(curve.rows.back().axial_stress, strongest, 1e-6 * strongest);
    EXPECT_NEAR(curve.rows.back().radial_stress, cell, 1e-6 * cell);
    EXPECT_TRUE(curve.stopped.empty());
    // Beyond failure dε_v/dε_a = -2 sin ψ/(1 - sin ψ).
    const PointRow &a = curve.rows[250], &b = curve.rows[300];
    const double dilatancy = -2 * std::sin(5 * degree) / (1 - std::sin(5 * degree));
    EXPECT_NEAR((b.volumetric_strain - a.volumetric_strain) / (b.axial_strain - a.axial_strain), dilatancy, 1e-5);
    test.axial_strain = {-0.06};
    curve = run_point_test(soil, test);
    const double weakest = (cell - 2 * c * std::sqrt(n)) / n;
    EXPECT_NEAR(curve.rows.back().axial_stress, weakest, 1e-6 * cell);
    EXPECT_NEAR(curve.rows.back().q, weakest - cell, 1e-6 * cell) << "q is negative in extension";
  }
}

TEST(PointStrength, SimpleShearHasTheStrengthOfDavis) {
  // At constant σ_v and ε_h: τ = (c cosφ + σ_v sinφ) cosψ/(1 - sinφ sinψ) (Davis 1968), which is c + σ_v tanφ for ψ =
  // φ.
  const double c = 5e3, vertical = 100e3, friction = 30 * degree;
  for (const double dilatancy : {0.0, 10 * degree, friction}) {
    input::PointTest test = make_ring_test(PointTestKind::simple_shear, vertical, 0.6);
    test.shear_strain = {0.3};
    test.steps = 3000;
    const PointCurve curve = run_point_test(make_frictional(c, friction, dilatancy), test);
    const double strength = (c * std::cos(friction) + vertical * std::sin(friction)) * std::cos(dilatancy) /
                            (1 - std::sin(friction) * std::sin(dilatancy));
    EXPECT_NEAR(curve.rows.back().shear_stress, strength, 1e-3 * strength) << "ψ = " << dilatancy / degree;
    EXPECT_NEAR(curve.rows.back().axial_stress, vertical, 1e-5 * vertical);
    EXPECT_DOUBLE_EQ(curve.rows.back().radial_strain, 0);
  }
}

TEST(PointStrength, StressControlEndsAtTheStrength) {
  const double c = 8e3, cell = 100e3, n = find_stress_ratio(30 * degree), strength = n * cell + 2 * c * std::sqrt(n);
  const input::Material soil = make_frictional(c, 30 * degree, 0);
  input::PointTest test = make_cell_test(PointTestKind::drained_triaxial, cell);
  test.control = PointControl::stress;
  test.steps = 100;
  test.axial_stress = {0.99 * strength};
  EXPECT_TRUE(run_point_test(soil, test).stopped.empty());
  test.axial_stress = {1.5 * strength};
  const PointCurve curve = run_point_test(soil, test);
  EXPECT_NEAR(curve.rows.back().axial_stress, strength, 1e-3 * strength);
  EXPECT_LE(curve.rows.back().axial_stress, strength * (1 + 1e-6));
  EXPECT_NE(curve.stopped.find("kPa and no more"), std::string::npos) << curve.stopped;
  EXPECT_NE(curve.stopped.find("were asked for"), std::string::npos) << curve.stopped;
}

TEST(PointStrength, AStartBeyondTheStrengthIsRefused) {
  input::PointTest test = make_cell_test(PointTestKind::drained_triaxial, 100e3);
  test.k0 = 0.2;
  test.axial_strain = {0.01};
  try {
    run_point_test(make_frictional(1e3, 30 * degree, 0), test);
    FAIL() << "500 kPa at a cell pressure of 100 kPa";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    EXPECT_NE(std::string(error.what()).find("test 'cell': the soil does not carry the stress at the start, 500 kPa"),
              std::string::npos)
        << error.what();
  }
}

TEST(PointStiffness, EachApparatusMeasuresItsModulus) {
  const double young = 30e6, nu = 0.25;
  const input::Material soil = make_elastic(young, nu);
  const auto find_slope = [&](input::PointTest test, double PointRow::*y, double PointRow::*x) {
    test.steps = 7;
    const PointCurve curve = run_point_test(soil, test);
    const PointRow &a = curve.rows.front(), &b = curve.rows.back();
    return (b.*y - a.*y) / (b.*x - a.*x);
  };
  const double oedometric = young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)), bulk = young / (3 * (1 - 2 * nu));
  for (const PointControl control : {PointControl::strain, PointControl::stress}) {
    const auto control_axially = [&](input::PointTest test) {
      test.control = control;
      if (control == PointControl::strain)
        test.axial_strain = {0.01};
      else
        test.axial_stress = {250e3};
      return test;
    };
    const auto triaxial = control_axially(make_cell_test(PointTestKind::drained_triaxial, 50e3));
    EXPECT_NEAR(find_slope(triaxial, &PointRow::q, &PointRow::axial_strain), young, 1e-6 * young);
    EXPECT_NEAR(find_slope(triaxial, &PointRow::radial_strain, &PointRow::axial_strain), -nu, 1e-6);
    const auto ring = control_axially(make_ring_test(PointTestKind::oedometer, 50e3, 0.5));
    EXPECT_NEAR(find_slope(ring, &PointRow::axial_stress, &PointRow::axial_strain), oedometric, 1e-6 * oedometric);
    EXPECT_NEAR(find_slope(ring, &PointRow::radial_stress, &PointRow::axial_stress), nu / (1 - nu), 1e-6);
    const auto isotropic = control_axially(make_cell_test(PointTestKind::isotropic_compression, 50e3));
    EXPECT_NEAR(find_slope(isotropic, &PointRow::p, &PointRow::volumetric_strain), bulk, 1e-6 * bulk);
    const auto k0 = control_axially(make_ring_test(PointTestKind::k0_compression, 50e3, 0.4));
    EXPECT_NEAR(find_slope(k0, &PointRow::radial_stress, &PointRow::axial_stress), 0.4, 1e-6);
    const auto undrained = control_axially(make_cell_test(PointTestKind::undrained_triaxial, 50e3));
    const double modulus = 1.5 * young / (1 + nu);  // 3G
    EXPECT_NEAR(find_slope(undrained, &PointRow::q, &PointRow::axial_strain), modulus, 1e-6 * modulus);
    EXPECT_NEAR(find_slope(undrained, &PointRow::pore_pressure, &PointRow::q), 1.0 / 3, 1e-6) << "Skempton's A";
  }
  input::PointTest shear = make_ring_test(PointTestKind::simple_shear, 50e3, 0.5);
  shear.shear_strain = {0.01};
  const double g = young / (2 * (1 + nu));
  EXPECT_NEAR(find_slope(shear, &PointRow::shear_stress, &PointRow::shear_strain), g, 1e-6 * g);
}

TEST(PointStiffness, TurningPointsAreReachedAndElasticSoilComesBack) {
  input::PointTest test = make_ring_test(PointTestKind::oedometer, 50e3, 0.5);
  test.control = PointControl::stress;
  test.axial_stress = {400e3, 100e3, 800e3, 50e3};
  test.steps = 100;
  const PointCurve curve = run_point_test(make_elastic(30e6, 0.25), test);
  EXPECT_NEAR(curve.rows.back().axial_strain, 0, 1e-12);
  double largest = 0;
  for (const PointRow& row : curve.rows) largest = std::max(largest, row.axial_stress);
  EXPECT_NEAR(largest, 800e3, 1) << "a turning point is a row";
  EXPECT_NEAR(static_cast<double>(curve.rows.size()), 101, 2);
}

}  // namespace
}  // namespace talus::laboratory
