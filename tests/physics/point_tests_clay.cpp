// SPDX-License-Identifier: MIT
// Element tests of Cam-clay against closed forms: compression lines, undrained strength, critical state, collapse.

#include "support/point_soils.hpp"

namespace talus::laboratory {
namespace {

using input::PointControl;
using input::PointTestKind;
using support::make_cell_test;
using support::make_clay;

constexpr double lambda = 0.089, kappa = 0.022, slope = 1.42;

TEST(PointClay, IsotropicCompressionFollowsTheSwellingAndTheNormalLine) {
  const double p0 = 50e3, pc = 125e3, e0 = 0.86;
  input::PointTest test = make_cell_test(PointTestKind::isotropic_compression, p0);
  test.control = PointControl::stress;
  test.axial_stress = {800e3, 100e3, 1600e3};
  test.steps = 4000;
  const PointCurve curve = run_point_test(make_clay(pc), test);
  ASSERT_TRUE(curve.stopped.empty()) << curve.stopped;
  double largest = 0;
  for (const PointRow& row : curve.rows) {
    // The largest pressure so far has set the swelling line.
    largest = std::max(largest, row.p);
    const double yielded = std::max(largest, pc);
    const double e =
        e0 - kappa * std::log(pc / p0) - lambda * std::log(yielded / pc) + kappa * std::log(yielded / row.p);
    ASSERT_NEAR(row.void_ratio, e, 2e-4) << "p' = " << row.p;
    ASSERT_NEAR(row.preconsolidation, yielded, 2e-3 * yielded);
  }
}

TEST(PointClay, UndrainedStrengthIsThatOfTheCriticalState) {
  // p' at failure = p'_0 (R/2)^Λ with Λ = (λ - κ)/λ, q = M p' (Wood 1990, section 7.2); both sides of R = 2.
  const double p0 = 100e3, exponent = (lambda - kappa) / lambda;
  for (const double ratio : {1.0, 1.5, 2.0, 4.0, 8.0}) {
    input::PointTest test = make_cell_test(PointTestKind::undrained_triaxial, p0);
    test.axial_strain = {0.4};
    test.steps = 8000;
    const PointCurve curve = run_point_test(make_clay(ratio * p0), test);
    const PointRow& end = curve.rows.back();
    const double p = p0 * std::pow(ratio / 2, exponent);
    EXPECT_NEAR(end.p, p, 5e-3 * p) << "overconsolidated " << ratio;
    EXPECT_NEAR(end.q, slope * p, 5e-3 * slope * p) << "overconsolidated " << ratio;
    // u = total p - p': the cell pressure stays.
    EXPECT_NEAR(end.pore_pressure, p0 + slope * p / 3 - p, 6e-3 * p0) << "overconsolidated " << ratio;
    EXPECT_NEAR(end.volumetric_strain, 0, 1e-12);
    EXPECT_NEAR(end.radial_stress + end.pore_pressure, p0, 1e-6 * p0);
  }
}

TEST(PointClay, DrainedCompressionAndExtensionEndAtTheCriticalState) {
  const double cell = 200e3;
  input::PointTest test = make_cell_test(PointTestKind::drained_triaxial, cell);
  test.axial_strain = {0.9};
  test.steps = 9000;
  PointRow end = run_point_test(make_clay(cell), test).rows.back();
  // q = M p' on the path dq = 3 dp'.
  EXPECT_NEAR(end.q, 3 * slope * cell / (3 - slope), 2e-3 * end.q);
  EXPECT_NEAR(end.preconsolidation, 2 * end.p, 5e-3 * end.preconsolidation);
  test.axial_strain = {-0.9};
  end = run_point_test(make_clay(cell), test).rows.back();
  // The model has one M: in extension q = -M p' on dq = 3 dp'.
  EXPECT_NEAR(end.q, -3 * slope * cell / (3 + slope), 3e-3 * -end.q);
}

TEST(PointClay, WettingCollapsesBySaturationAlone) {
  // Isotropic, on the normal line: p'_c = p_b exp(b(1 - S)) = p' all the way, so
  // Δe = -λ Δln p' - (λ - κ)(b ΔS) with p' = p_net + S s.
  input::Material soil = make_clay(50e3);
  soil.suction_hardening = 1.5;
  soil.water.retention = input::RetentionCurve::van_genuchten;
  soil.water.reference_pressure = 30e3;
  soil.water.lambda = 0.4;
  input::PointTest test = make_cell_test(PointTestKind::wetting, 400e3);
  test.suction = {100e3, 0};
  test.steps = 2000;
  const PointCurve curve = run_point_test(soil, test);
  ASSERT_TRUE(curve.stopped.empty()) << curve.stopped;
  const PointRow &dry = curve.rows.front(), &wet = curve.rows.back();
  const double s0 = std::pow(1 + std::pow(100.0 / 30, 1 / 0.6), -0.4);
  EXPECT_NEAR(dry.saturation, s0, 1e-12);
  EXPECT_NEAR(dry.p, 400e3 + s0 * 100e3, 1e-3);
  EXPECT_NEAR(wet.p, 400e3, 1e-2);
  const double collapse = (lambda - kappa) * 1.5 * (1 - s0) + lambda * std::log(wet.p / dry.p);
  ASSERT_GT(collapse, 0.01);
  EXPECT_NEAR(dry.void_ratio - wet.void_ratio, collapse, 3e-3 * collapse);
  EXPECT_NEAR(wet.preconsolidation, wet.p, 1e-3 * wet.p);

  // Inside the yield surface the soil only swells, as the effective stress falls.
  soil.preconsolidation = 900e3;
  const PointCurve stiff = run_point_test(soil, test);
  EXPECT_NEAR(stiff.rows.front().void_ratio - stiff.rows.back().void_ratio,
              kappa * std::log(stiff.rows.back().p / stiff.rows.front().p), 2e-5);
  EXPECT_LT(stiff.rows.back().volumetric_strain, 0);
  // p'_c shrinks by exp(b ΔS) all the same.
  EXPECT_NEAR(stiff.rows.back().preconsolidation / stiff.rows.front().preconsolidation, std::exp(-1.5 * (1 - s0)),
              1e-9);
}

TEST(PointClay, NormalK0CompressionIsParallelToTheNormalLine) {
  input::PointTest test = support::make_ring_test(PointTestKind::oedometer, 100e3, 0.5);
  test.control = PointControl::stress;
  test.axial_stress = {3200e3};
  test.steps = 4000;
  const PointCurve curve = run_point_test(make_clay(90e3), test);
  ASSERT_TRUE(curve.stopped.empty()) << curve.stopped;
  const PointRow& end = curve.rows.back();
  const PointRow* middle = &end;
  for (const PointRow& row : curve.rows)
    if (row.axial_stress > 1600e3) {
      middle = &row;
      break;
    }
  EXPECT_NEAR((middle->void_ratio - end.void_ratio) / std::log(end.axial_stress / middle->axial_stress), lambda,
              0.005 * lambda);
  EXPECT_NEAR(middle->radial_stress / middle->axial_stress, end.radial_stress / end.axial_stress, 2e-3);
}

}  // namespace
}  // namespace talus::laboratory
