// SPDX-License-Identifier: MIT
#pragma once
// Runs whose summary.json the tests read as JSON.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "input/case/result_names.hpp"
#include "results/json.hpp"
#include "results/named.hpp"
#include "run/common/head.hpp"
#include "run/run_case.hpp"

namespace talus::support {

/// Runs a case, and expects that [[compare]] accepts the name of each of its numbers.
inline nlohmann::json run_case(const input::LoadedCase& loaded, const run::RunOptions& options) {
  const results::RunResult run = run::run_case(loaded, options);
  const std::vector<results::NamedValue> known = input::list_result_names(loaded.data);
  for (const results::NamedValue& value : results::list_values(run, loaded.data.mesh.dimension)) {
    const auto is_named = [&](const results::NamedValue& v) { return results::is_same_result(v.name, value.name); };
    EXPECT_TRUE(std::any_of(known.begin(), known.end(), is_named)) << value.name;
  }
  return results::to_json(run);
}

inline results::RunResult to_run(const nlohmann::json& summary) {
  return results::from_json<results::RunResult>(summary, "summary.json");
}

inline std::optional<double> find_result(const nlohmann::json& summary, const std::string& name) {
  return run::find_result(to_run(summary), name);
}

}  // namespace talus::support
