// SPDX-License-Identifier: MIT
#pragma once
// Soils and element tests for the tests, made in memory as in calibration.

#include <gtest/gtest.h>

#include <cmath>

#include "laboratory/point_test.hpp"
#include "material/cam_clay.hpp"

namespace talus::support {

inline input::Material make_elastic(double young_modulus, double poisson_ratio) {
  input::Material soil;
  soil.grain_density = 2700;
  soil.porosity = 0.4;
  soil.young_modulus = young_modulus;
  soil.poisson_ratio = poisson_ratio;
  return soil;
}

/// Angles [rad]; tension is cut off at the apex.
inline input::Material make_frictional(double cohesion, double friction, double dilatancy) {
  input::Material soil = make_elastic(20e6, 0.3);
  soil.model = material::model_of<material::MohrCoulomb>;
  soil.cohesion = cohesion;
  soil.friction_angle = friction;
  soil.dilatancy_angle = dilatancy;
  soil.tensile_strength = cohesion / std::tan(friction);
  return soil;
}

/// Loess of Table 4.1 of the source without roots, with a preconsolidation pressure [Pa].
inline input::Material make_clay(double preconsolidation) {
  input::Material soil = make_elastic(0, 0.3);
  soil.model = material::model_of<material::ModifiedCamClay>;
  soil.porosity = 0.86 / 1.86;
  soil.compression = 0.089;
  soil.swelling = 0.022;
  soil.critical_state_slope = 1.42;
  soil.preconsolidation = preconsolidation;
  return soil;
}

/// A test from a cell pressure [Pa].
inline input::PointTest make_cell_test(input::PointTestKind kind, double pressure) {
  input::PointTest test;
  test.name = "cell";
  test.kind = kind;
  test.confining_pressure = pressure;
  return test;
}

/// A test from a vertical stress [Pa] and K0.
inline input::PointTest make_ring_test(input::PointTestKind kind, double vertical, double k0) {
  input::PointTest test;
  test.name = "ring";
  test.kind = kind;
  test.vertical_stress = vertical;
  test.k0 = k0;
  return test;
}

/// The row nearest to an axial strain.
inline const laboratory::PointRow& find_row(const laboratory::PointCurve& curve, double axial_strain) {
  const laboratory::PointRow* nearest = &curve.rows.front();
  for (const laboratory::PointRow& row : curve.rows)
    if (std::abs(row.axial_strain - axial_strain) < std::abs(nearest->axial_strain - axial_strain)) nearest = &row;
  return *nearest;
}

}  // namespace talus::support
