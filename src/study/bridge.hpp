#pragma once
// What the run floor will say in structs; for as long as it speaks JSON, said here.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "results/json.hpp"
#include "results/laboratory.hpp"
#include "results/run.hpp"
#include "run/named_results.hpp"
#include "run/run_case.hpp"
#include "run/summary.hpp"

namespace talus::bridge {

inline results::RunResult run_case(const input::LoadedCase& loaded, const run::RunOptions& options) {
  return results::from_json<results::RunResult>(run::run_case(loaded, options), "summary.json");
}

inline std::optional<double> find_result(const results::RunResult& result, const std::string& name) {
  return run::find_result(results::to_json(result), name);
}

inline std::vector<results::Comparison> compare_results(const input::Case& data, const results::PointTests& tests) {
  const nlohmann::json list = run::compare_results(data, results::to_json(tests));
  return results::from_json<results::PointTests>({{"comparisons", list}}, "point.json").comparisons;
}

inline results::Project describe_project(const input::Case& data) {
  return results::from_json<results::PointTests>({{"project", run::describe_project(data)}}, "").project;
}

inline results::Provenance describe_provenance(const input::LoadedCase& loaded, const std::string& hash, int threads) {
  return results::from_json<results::PointTests>({{"provenance", run::describe_provenance(loaded, hash, threads)}}, "")
      .provenance;
}

}  // namespace talus::bridge
