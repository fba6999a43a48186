#include "report/content/head.hpp"

#include "report/look_up.hpp"

namespace talus::report {

using nlohmann::json;

json make_project(const json& summary) {
  json project{{"title", get_text(summary, {"title"})}, {"date", get_text(summary, {"provenance", "started"})}};
  for (const char* key : {"project", "client", "author", "checked_by", "revision", "notes"})
    project[key] = get_text(summary, {"project", key});
  if (project["title"] == "") project["title"] = get_text(summary, {"project", "title"}, "Untitled case");
  return project;
}

json make_provenance(const json& summary, const std::filesystem::path& folder) {
  json provenance;
  for (const char* key : {"program", "version", "commit", "compiler", "build_type", "architecture", "machine",
                          "started", "case_file", "input_hash"})
    provenance[key] = get_text(summary, {"provenance", key});
  for (const char* key : {"lane_width", "threads"}) provenance[key] = get_number(summary, {"provenance", key});
  std::filesystem::path name = std::filesystem::absolute(folder).lexically_normal();
  if (!name.has_filename()) name = name.parent_path();
  provenance["folder"] = name.filename().string();
  return provenance;
}

json make_timing(const json& summary) {
  json timing{{"wall", get_number(summary, {"timing", "wall"})},
              {"cpu", get_number(summary, {"timing", "cpu"})},
              {"parts", find_list(summary, {"timing", "parts"})}};
  // Older folders know the parts of the stages' steps only.
  const json* steps = find(summary, {"timing", "stage_steps"});
  if (!timing["parts"].empty() || steps == nullptr) return timing;
  for (const auto& [name, seconds] : steps->items()) {
    std::string title = "stages: " + name;
    for (char& c : title)
      if (c == '_') c = ' ';
    timing["parts"].push_back({{"name", name}, {"title", title}, {"seconds", seconds}});
  }
  return timing;
}

}  // namespace talus::report
