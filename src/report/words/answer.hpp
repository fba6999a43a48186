#pragma once
// The answer of a run in plain words, and the factors of safety with what they rest on.

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "report/folder.hpp"

namespace talus::report {

/// The factor of safety that the first sentence names: of material points at frozen geometry, else by the first
/// criterion of the curve that found one; without material points of slices, else of finite elements.
std::optional<double> find_main_factor(const ResultFolder& folder);

/// `Answer` of web/src/contract/.
nlohmann::json make_answer(const ResultFolder& folder);

}  // namespace talus::report
