#include "model/read.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "model/checks.hpp"
#include "model/declare_case.hpp"
#include "model/echo.hpp"
#include "model/reader.hpp"

namespace talus::model {
namespace {

std::string read_text(const std::string& path) {
  if (std::filesystem::is_directory(path)) throw InputError({{path, 0, 0, "this is a folder; a case is a TOML file"}});
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file) throw InputError({{path, 0, 0, fmt::format("the case file cannot be opened: {}", std::strerror(errno))}});
  return text.str();
}

toml::table parse(const std::string& text, const std::string& name) {
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError({{name, static_cast<int>(at.line), static_cast<int>(at.column),
                       fmt::format("this is not TOML: {}", error.description())}});
  }
}

void normalise(std::array<double, 3>& v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  if (length > 0)
    for (double& component : v) component /= length;
}

/// What follows from several keys.
void complete(Case& data, const std::string& file, const Places& places) {
  if (data.mesh.dimension == 3 && !places.is_given("mesh.points_per_element")) data.points_per_element = 4;
  if (!data.mesh.file.empty())
    data.mesh.file = (std::filesystem::path(file).parent_path() / data.mesh.file).lexically_normal().string();
  if (data.initial.result.empty()) return;
  data.initial.result_folder =
      (std::filesystem::path(file).parent_path() / data.initial.result).lexically_normal().string();
  // The mesh of a result cannot be halved.
  if (!places.is_given("strength_reduction.frozen.meshes")) data.strength_reduction.frozen.meshes = 1;
}

/// Units of length for what was given as a direction; after the checks, which look for directions without length.
void normalise_directions(Case& data) {
  normalise(data.gravity.direction);
  for (Boundary& boundary : data.boundaries)
    if (boundary.fix == Fix::plane) normalise(boundary.normal);
}

std::optional<LoadedCase> read_without_study(const std::string& text, const std::string& name,
                                             const std::vector<Override>& overrides, Findings& findings) {
  toml::table root = parse(text, name);
  apply_overrides(root, overrides, findings);
  LoadedCase loaded;
  // [geometry] comes first in the file, and has to know whether [mesh] names a ready mesh.
  loaded.data.mesh.file = root["mesh"]["file"].value_or(std::string());
  Reader reader(root, findings);
  describe(reader, loaded.data);
  reader.finish();
  complete(loaded.data, name, findings.places);
  check_geometry(loaded.data, findings);
  check_materials(loaded.data, findings);
  check_conditions(loaded.data, findings);
  check_water(loaded.data, findings);
  check_hydraulics(loaded.data, findings);
  check_result(loaded.data, findings);
  check_analysis(loaded.data, findings);
  check_compare(loaded.data, findings);
  if (!findings.empty()) return std::nullopt;
  loaded.echo = echo(loaded.data, findings.places);
  normalise_directions(loaded.data);
  loaded.text = text;
  loaded.file = name;
  return loaded;
}

/// A value of a study is right when the case that it makes is right.
void check_study(const LoadedCase& loaded, const std::vector<Override>& overrides, Findings& findings) {
  const std::vector<Vary>& vary = loaded.data.study.vary;
  for (std::size_t i = 0; i < vary.size(); ++i) {
    for (std::size_t j = 0; j < vary[i].values.size(); ++j) {
      std::vector<Override> changes = overrides;
      changes.push_back({vary[i].key, vary[i].values[j]});
      Places trial_places(loaded.file);
      Findings trial(trial_places);
      if (read_without_study(loaded.text, loaded.file, changes, trial)) continue;
      findings.add(fmt::format("study.vary.{}.values.{}", i, j),
                   fmt::format("the study cannot set {} = {}: {}", vary[i].key, vary[i].values[j],
                               trial.sort().front().sentence));
      // A key that does not exist is wrong once, not once for each of its values.
      if (trial.sort().front().sentence.rfind("unknown key", 0) == 0) break;
    }
  }
}

}  // namespace

LoadedCase read_case_text(const std::string& text, const std::string& name, const std::vector<Override>& overrides) {
  Places places(name);
  Findings findings(places);
  std::optional<LoadedCase> loaded = read_without_study(text, name, overrides, findings);
  if (loaded) check_study(*loaded, overrides, findings);
  if (!findings.empty()) throw InputError(findings.sort());
  loaded->places = std::move(places);
  return std::move(*loaded);
}

LoadedCase read_case(const std::string& path, const std::vector<Override>& overrides) {
  return read_case_text(read_text(path), path, overrides);
}

void check_against_mesh(const LoadedCase& loaded, const std::set<std::string>& sides,
                        const std::set<std::string>& regions) {
  Places places = loaded.places;
  Findings findings(places);
  check_sides(loaded.data, sides, findings);
  check_regions(loaded.data, regions, findings);
  if (!findings.empty()) throw InputError(findings.sort());
}

}  // namespace talus::model
