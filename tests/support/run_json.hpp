// SPDX-License-Identifier: MIT
#pragma once
// Runs whose summary.json the tests read as JSON.

#include <nlohmann/json.hpp>

#include "results/json.hpp"
#include "run/head.hpp"
#include "run/run_case.hpp"

namespace talus::support {

inline nlohmann::json run_case(const input::LoadedCase& loaded, const run::RunOptions& options) {
  return results::to_json(run::run_case(loaded, options));
}

inline results::RunResult to_run(const nlohmann::json& summary) {
  return results::from_json<results::RunResult>(summary, "summary.json");
}

inline std::optional<double> find_result(const nlohmann::json& summary, const std::string& name) {
  return run::find_result(to_run(summary), name);
}

}  // namespace talus::support
