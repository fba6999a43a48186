// SPDX-License-Identifier: MIT
#pragma once
// The answer of a run in plain words, and the factors of safety with their basis.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/report.hpp"

namespace talus::report {

/// Stages that were to end at rest and did not: all displacements and runouts are those of soil that still moves.
std::vector<std::string> list_unrest(const results::RunResult& run);

/// `Answer` of web/src/contract/.
nlohmann::json make_answer(const ResultFolder& folder);

}  // namespace talus::report
