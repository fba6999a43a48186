// SPDX-License-Identifier: MIT
#pragma once
// The head of the results of every run: title block, program, machine, units and input; and named results with their
// comparison to expected values.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/read.hpp"
#include "results/laboratory.hpp"
#include "results/run.hpp"

namespace talus::run {

/// Title block of the report.
results::Project make_project(const input::Case& data);

/// Origin of the numbers: program, build, machine and input.
results::Provenance make_provenance(const input::LoadedCase& loaded, const std::string& input_hash, int threads);

results::DisplayUnits make_display_units(const input::Output& output);

/// Makes a result with title, project, provenance, units, outlines and input.
results::RunResult begin_result(const input::LoadedCase& loaded, const std::string& input_hash, int threads);

/// Formats a length for a sentence, in the unit of the case: "1.22 m", "4 ft".
std::string format_length(const results::RunResult& run, double metres, int digits = 3);

/// Rounds `value` to 1/`digits` for files: digits = 1e6 keeps six decimal places.
inline double round_to(double value, double digits) {
  return std::round(value * digits) / digits;
}

// Names of results are those of input/case/result_names.hpp.

/// Returns the result `name` of a run [SI]; nullopt if the run did not reach it. The displacement of a trial that was
/// not run is interpolated between its neighbours on the curve.
std::optional<double> find_result(const results::RunResult& run, const std::string& name);

/// Lists all results that the case yields and the run reached, with their display units.
std::vector<results::NamedResult> list_results(const input::Case& data, const results::RunResult& run);

/// Evaluates [[compare]] of the case for a run, each entry with the computed value, the tolerance in SI, and whether
/// it passes.
std::vector<results::Comparison> compare_results(const input::Case& data, const results::RunResult& run);
/// Evaluates [[compare]] for element tests, which are not part of a run.
std::vector<results::Comparison> compare_results(const input::Case& data, const results::PointTests& tests);

}  // namespace talus::run
