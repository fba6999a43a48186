// SPDX-License-Identifier: MIT
#pragma once
// A study with sampled numbers in a report: distributions, probability of failure, sensitivities, runout.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "results/sampling.hpp"

namespace talus::report {

/// `Sampling` of web/src/contract/.
nlohmann::json make_sampling(const results::Sampling& sampling);

/// The answer of a sampling in words, the most important sentence first.
void format_sampling(const results::Sampling& sampling, std::vector<std::string>& sentences);

}  // namespace talus::report
