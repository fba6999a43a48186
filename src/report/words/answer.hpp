// SPDX-License-Identifier: MIT
#pragma once
// The answer of a run in plain words, and the factors of safety with their basis.

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "report/folder.hpp"

namespace talus::report {

/// `Answer` of web/src/contract/.
nlohmann::json make_answer(const ResultFolder& folder);

}  // namespace talus::report
