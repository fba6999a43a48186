// SPDX-License-Identifier: MIT
#pragma once
// The answer of a run in plain words, with the factors of safety and their basis.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/folder/result_folder.hpp"

namespace talus::report {

/// Returns sentences on the stages that were to end at rest but did not; their displacements and runouts are not final.
std::vector<std::string> list_unrest(const results::RunResult& run);

/// Returns `Answer` of web/src/contract/.
nlohmann::json make_answer(const ResultFolder& folder);

}  // namespace talus::report
