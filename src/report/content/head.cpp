// SPDX-License-Identifier: MIT
#include "report/content/head.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

json make_project(const results::RunResult& run) {
  json project = results::to_json(run.project);
  project["date"] = run.provenance.started;
  const std::string& title = run.title.empty() ? run.project.title : run.title;
  project["title"] = title.empty() ? "Untitled case" : title;
  return project;
}

json make_provenance(const ResultFolder& folder) {
  json provenance = results::to_json(folder.run.provenance);
  std::filesystem::path name = std::filesystem::absolute(folder.path).lexically_normal();
  if (!name.has_filename()) name = name.parent_path();
  provenance["folder"] = name.filename().string();
  return provenance;
}

json make_timing(const results::RunResult& run) {
  const results::Timing timing = run.timing.value_or(results::Timing{});
  json parts = results::to_json(timing.parts.value_or(std::vector<results::TimedPart>{}));
  // Older folders know the parts of the stages' steps only.
  if (parts.empty() && timing.stage_steps)
    for (const auto& [name, seconds] : results::to_json(*timing.stage_steps).items()) {
      std::string title = "stages: " + name;
      std::replace(title.begin(), title.end(), '_', ' ');
      parts.push_back({{"name", name}, {"title", title}, {"seconds", seconds}});
    }
  return {{"wall", timing.wall}, {"cpu", timing.cpu.value_or(0)}, {"parts", parts}};
}

}  // namespace talus::report
