// SPDX-License-Identifier: MIT
#pragma once
// The head of the results of every run: title block, program, machine, units, input.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/read.hpp"
#include "results/laboratory.hpp"
#include "results/run.hpp"

namespace talus::run {

/// The title block of the report.
results::Project make_project(const input::Case& data);

/// Program, build, machine and input: where a number comes from.
results::Provenance make_provenance(const input::LoadedCase& loaded, const std::string& input_hash, int threads);

/// The units of display.
results::DisplayUnits make_display_units(const input::Output& output);

/// Title, project, provenance, units, outlines and input.
results::RunResult begin_result(const input::LoadedCase& loaded, const std::string& input_hash, int threads);

/// A length in sentences, in the unit of the case: "1.22 m", "4 ft".
std::string format_length(const results::RunResult& run, double metres, int digits = 3);

// Numbers that files need not keep to the last digit.

/// `value` to 1/`digits`: digits = 1e6 keeps six digits after the point.
inline double round_to(double value, double digits) {
  return std::round(value * digits) / digits;
}

// Results under the names of input/case/result_names.hpp, and how they compare with what the case expects.

/// The result `name` of a run [SI]; nothing when the run did not reach it. The displacement of a trial that was not
/// calculated is interpolated between its neighbours on the curve.
std::optional<double> find_result(const results::RunResult& run, const std::string& name);

/// All results that the case yields and the run reached, with the units in which they are shown.
std::vector<results::NamedResult> list_results(const input::Case& data, const results::RunResult& run);

/// The case's [[compare]] of results of a run, each with the computed value, the tolerance in SI, and whether it
/// passes.
std::vector<results::Comparison> compare_results(const input::Case& data, const results::RunResult& run);
/// The same of element tests: a run has none of theirs, and they are no part of a run.
std::vector<results::Comparison> compare_results(const input::Case& data, const results::PointTests& tests);

}  // namespace talus::run
