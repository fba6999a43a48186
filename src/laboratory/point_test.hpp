// SPDX-License-Identifier: MIT
#pragma once
// Element tests: one point of soil without a mesh, driven by strains and stresses.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/case/point_test.hpp"
#include "laboratory/point_soil.hpp"

namespace talus::laboratory {

// What an element test does to its point, step by step.

/// Stresses of a specimen as the apparatus knows them, compression positive [Pa].
struct Cell {
  double axial = 0, radial = 0;
};

Cell find_start(const input::PointTest& test);

/// The step that moves what the test follows from `from` to `to`. `sucked` is χs at its end [Pa].
PointStep make_step(const input::PointTest& test, const Cell& start, double from, double to, double sucked);

/// What the test follows, at its start and at each of its goals.
std::vector<double> list_turns(const input::PointTest& test);

/// The same at every step. `reached` receives the steps of the goals.
std::vector<double> list_values(const input::PointTest& test, std::vector<std::size_t>& reached);

/// One row of a test. Compression and contraction are positive, as in a laboratory's report. Strains are sums of the
/// increments, as in the engine (logarithmic ones).
struct PointRow {
  double time = 0;                                               ///< running parameter of the test, 0 … 1
  double axial_strain = 0, radial_strain = 0, shear_strain = 0;  ///< ε_a, ε_r, γ of simple shear [-]
  double volumetric_strain = 0, deviatoric_strain = 0;           ///< ε_v, ε_q = √(⅔ e:e) [-]
  double axial_stress = 0, radial_stress = 0, shear_stress = 0;  ///< effective [Pa]
  double p = 0, q = 0;       ///< mean effective and deviatoric stress; q < 0 where the axial stress is the smaller [Pa]
  double pore_pressure = 0;  ///< excess, undrained tests [Pa]
  double suction = 0, saturation = 1, void_ratio = 0;  ///< [Pa], [-], [-]
  double preconsolidation = 0;                         ///< p'_c, 0 for laws without one [Pa]
};

struct PointCurve {
  std::vector<PointRow> rows;
  std::vector<std::size_t> turns;  ///< rows at which the test reached a goal of its list
  std::string stopped;             ///< why the test ended before its goal, one sentence; empty when it did not
};

/// Runs `test` on soil `material` (Case::test_soils holds it with what the test sets). A soil that cannot follow to the
/// end gives the curve as far as it goes. Throws Error (wrong_input) when the soil does not carry the stress at the
/// start, and Error (unstable) with the test's name when the model yields no number.
PointCurve run_point_test(const input::Material& material, const input::PointTest& test);

/// A quantity of a row by its name, one of input::list_point_quantities().
double get_quantity(const PointRow& row, const std::string& name);

}  // namespace talus::laboratory
