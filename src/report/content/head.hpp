// SPDX-License-Identifier: MIT
#pragma once
// The title block, provenance and timing.

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "report/report.hpp"
#include "results/runout.hpp"

namespace talus::report {

/// Project, Provenance and Timing of web/src/contract/.
nlohmann::json make_project(const results::RunResult& run);
nlohmann::json make_provenance(const ResultFolder& folder);
nlohmann::json make_timing(const results::RunResult& run);

// The clock of a case ([output] count_from) and the stored frames that are shown by it.

/// Which of the ascending `times` [s] of the run are shown: those nearest to the times that are asked for (of two at
/// one time the later one), or five evenly spread from the start of the clock on.
std::vector<std::size_t> choose_shown(const std::vector<double>& times, const results::Clock& clock);

// The results of a run by name (`NamedResult` in web/src/contract/).

/// The results, without the zeros that a runout without any soil comes to.
nlohmann::json list_named_results(const ResultFolder& folder);

}  // namespace talus::report
