// SPDX-License-Identifier: MIT
#pragma once
// Results of a run for the page, and two runs side by side: the keys of their inputs and the named results that differ.

#include <nlohmann/json_fwd.hpp>

#include "results/run.hpp"

namespace talus::studio {

/// Returns {title, status, program, values: [{name, title, unit, value}], surfaces: [{name, title, method, factor,
/// points [m]}], warnings}. Values are in their `unit`, which is that of display.
nlohmann::json list_run(const results::RunResult& run);

/// Returns
///   inputs   [{key, first, second, unit}] of the keys whose values differ, as text; null where a case lacks the key
///   values   [{name, title, unit, first, second, difference, relative}] of all named results of one or both runs, in
///            the order of the report, in the unit of the first run; null where a run lacks it
///   warnings [text], such as runs by different programs
/// `relative` is the difference over the first value.
nlohmann::json compare_runs(const results::RunResult& first, const results::RunResult& second);

}  // namespace talus::studio
