// SPDX-License-Identifier: MIT
#pragma once
// Element tests: one point of soil without a mesh, driven by strains and stresses.

#include <filesystem>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/case/point_test.hpp"
#include "input/read.hpp"
#include "laboratory/point_soil.hpp"
#include "results/laboratory.hpp"

namespace talus::laboratory {

/// Total stresses of a specimen in the apparatus, compression positive [Pa].
struct Cell {
  double axial = 0, radial = 0;
};

Cell find_start(const input::PointTest& test);

/// Makes the step that changes the controlled quantity from `from` to `to`. `sucked` is χs at its end [Pa].
PointStep make_step(const input::PointTest& test, const Cell& start, double from, double to, double sucked);

/// Values of the controlled quantity at the start and at each goal.
std::vector<double> list_turns(const input::PointTest& test);

/// Values of the controlled quantity at every step. `reached` receives the steps of the goals.
std::vector<double> list_values(const input::PointTest& test, std::vector<std::size_t>& reached);

/// One row of a test. Compression and contraction are positive, as in laboratory reports. Strains are sums of the
/// increments, as in MPM (logarithmic ones).
struct PointRow {
  double time = 0;                                               ///< running parameter of the test, 0 … 1
  double axial_strain = 0, radial_strain = 0, shear_strain = 0;  ///< ε_a, ε_r, γ of simple shear [-]
  double volumetric_strain = 0, deviatoric_strain = 0;           ///< ε_v, ε_q = √(⅔ e:e) [-]
  double axial_stress = 0, radial_stress = 0, shear_stress = 0;  ///< effective [Pa]
  double p = 0, q = 0;  ///< mean effective and deviatoric stress; q < 0 if the axial stress is the smaller one [Pa]
  double pore_pressure = 0;                            ///< excess, undrained tests [Pa]
  double suction = 0, saturation = 1, void_ratio = 0;  ///< [Pa], [-], [-]
  double preconsolidation = 0;                         ///< p'_c, 0 for laws without one [Pa]
};

struct PointCurve {
  std::vector<PointRow> rows;
  std::vector<std::size_t> turns;  ///< rows at which the test reached a goal of its list
  std::string stopped;             ///< why the test ended before its goal, one sentence; empty if it did not
};

/// Runs `test` on the soil `material` (from Case::test_soils, with the settings of the test); `stress` is the unit of
/// messages. A soil that fails before
/// the end gives the curve up to there. Throws Error (wrong_input) if the initial stress exceeds the strength of the
/// soil, and Error (unstable) with the name of the test if the model returns NaN.
PointCurve run_point_test(const input::Material& material, const input::PointTest& test,
                          const ShownUnit& stress = ShownUnits{}.stress);

/// Returns a quantity of a row by its name, one of input::list_point_quantities().
double get_quantity(const PointRow& row, const std::string& name);

// `talus point`: the element tests of a case, and the files of their results.

struct PointOptions {
  std::filesystem::path folder;    ///< folder of point/
  std::vector<std::string> names;  ///< of the tests to run; empty: all
  std::string pictures = "svg";    ///< "svg" or "png"
};

/// Runs the tests and writes into folder/point: a table NAME.csv for each, a picture for each group, and point.json
/// last. Returns the content of point.json. Throws Error (wrong_input) if the case has no such tests, what
/// run_point_test() throws, and Error (cannot_write).
results::PointTests run_point_tests(const input::LoadedCase& loaded, const PointOptions& options);

/// Formats a short summary for the terminal.
std::string write_point_digest(const results::PointTests& tests);

}  // namespace talus::laboratory
