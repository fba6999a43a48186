#pragma once
// A study with sampled numbers in a report: distributions, probability of failure, sensitivities, runout.

#include <nlohmann/json.hpp>

namespace talus::report {

/// `Sampling` of web/src/contract/ from the block of study.json.
nlohmann::json make_sampling(const nlohmann::json& block);

/// The answer of a sampling in words, the most important sentence first.
void say_sampling(const nlohmann::json& block, nlohmann::json& sentences);

}  // namespace talus::report
