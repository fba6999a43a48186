// SPDX-License-Identifier: MIT
#pragma once
// The sentences of a report: the answer, the assumptions, and those on pore water.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/folder/result_folder.hpp"

namespace talus::report {

// The answer of a run in plain words, with the factors of safety and their basis.

/// Returns sentences on the stages that were to end at rest but did not; their displacements and runouts are not final.
std::vector<std::string> list_unrest(const results::RunResult& run);

/// Returns `Answer` of web/src/contract/.
nlohmann::json make_answer(const ResultFolder& folder);

// Assumptions and limits of a run, as sentences derived from its case and its results; and the paragraphs of the
// methods section that apply to it (`Method` in web/src/contract/).

/// Returns the paragraphs that apply, in reading order.
nlohmann::json list_methods(const ResultFolder& folder);

/// Returns the sentences that apply, the most general first.
nlohmann::json list_assumptions(const ResultFolder& folder);

// Sentences on pore water: results for the answer of a report, assumptions, and the initial state with its seepage
// exits, closed sides and ponded water.

/// Returns the sentences on the results; empty if the ground is dry.
std::vector<std::string> describe_water(const ResultFolder& folder);

/// Returns the assumptions of a wet case and their limits; empty if the ground is dry.
std::vector<std::string> list_water_assumptions(const ResultFolder& folder);

/// Returns the sentences on the initial state of the pore water; empty if the ground is dry.
std::vector<std::string> describe_water_state(const ResultFolder& folder);

}  // namespace talus::report
