// SPDX-License-Identifier: MIT
#pragma once
// Results under the names of input/case/result_names.hpp, and how they compare with what the case expects.

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/laboratory.hpp"
#include "results/run.hpp"

namespace talus::run {

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
