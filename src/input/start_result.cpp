// SPDX-License-Identifier: MIT
// Check that a case fits the result that it starts from: dimension, points, regions and soils.

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "input/case/checks.hpp"
#include "input/case/start.hpp"
#include "input/read.hpp"

namespace talus::input {

namespace {

using nlohmann::json;

/// Returns the value at a path of an echo; null if there is none.
json look_up(const json& echo, const std::vector<std::string>& path) {
  const json* at = &echo;
  for (const std::string& step : path) {
    if (!at->is_object() || !at->contains(step)) return nullptr;
    at = &at->at(step);
  }
  return at->is_object() ? at->value("value", json()) : json();
}

std::set<std::string> list_regions(const json& echo) {
  std::set<std::string> names;
  if (echo.contains("regions"))
    for (const auto& [name, material] : echo.at("regions").items()) names.insert(name);
  return names;
}

/// Comparison of the echoes of the case and of the result that it starts from.
class Comparison {
 public:
  Comparison(const LoadedCase& loaded, const json& before, Findings& findings)
      : now_(loaded.echo.get()),
        before_(before),
        result_(fmt::format("the result '{}'", loaded.data.initial.result)),
        findings_(findings) {}

  void check() {
    const json dimension = look_up(before_, {"geometry", "dimension"}),
               wanted = look_up(now_, {"geometry", "dimension"});
    if (dimension != wanted)
      return findings_.add(findings_.places.is_given("geometry.dimension") ? "geometry.dimension" : "initial.result",
                           "{} has dimension {}, and this case has dimension {}", result_, dimension.dump(),
                           wanted.dump());
    check_points();
    const std::set<std::string> old_regions = list_regions(before_), regions = list_regions(now_);
    for (const std::string& region : regions) {
      if (old_regions.contains(region))
        check_soil(region);
      else
        findings_.add("regions." + region, "there is no region '{}' in {}; it has '{}'", region, result_,
                      fmt::join(old_regions, "', '"));
    }
    for (const std::string& region : old_regions)
      if (!regions.contains(region))
        findings_.add("regions",
                      "{} has a region '{}', which has no material here: write {} = \"MATERIAL\" in [regions]", result_,
                      region, region);
  }

 private:
  void check_points() {
    const std::string path = "mesh.points_per_element";
    const json count = look_up(before_, {"mesh", "points_per_element"}),
               wanted = look_up(now_, {"mesh", "points_per_element"});
    if (findings_.places.is_given(path) && count != wanted)
      findings_.add(path, "'points_per_element' is {}, but the points are those of {}, which has {}", wanted.dump(),
                    result_, count.dump());
  }

  void check_soil(const std::string& region) {
    const std::string name = look_up(now_, {"regions", region}), old = look_up(before_, {"regions", region});
    const std::string path = "materials." + name;
    const auto is_wet = [](const json& echo, const std::string& material) {
      const json curve = look_up(echo, {"materials", material, "water", "retention"});
      return curve.is_string() && curve != "dry";
    };
    const bool wet = is_wet(now_, name);
    if (wet != is_wet(before_, old))
      findings_.add(wet ? path + ".water" : path,
                    "material '{}' is {}, but region '{}' is {} in {}; a start from there can change the parameters of "
                    "a soil, not whether it has pore water",
                    name, wet ? "wet" : "dry", region, wet ? "dry" : "wet", result_);
    check_number(region, name, "grain_density", look_up(now_, {"materials", name, "grain_density"}),
                 look_up(before_, {"materials", old, "grain_density"}));
    // One case may give the void ratio, the other the porosity.
    const bool by_ratio = !look_up(now_, {"materials", name, "void_ratio"}).is_null();
    check_number(region, name, by_ratio ? "void_ratio" : "porosity", find_pores(now_, name, by_ratio),
                 find_pores(before_, old, by_ratio));
  }

  /// Returns the void ratio or the porosity of a material, converted if its case gives the other.
  static json find_pores(const json& echo, const std::string& material, bool as_ratio) {
    json given = look_up(echo, {"materials", material, as_ratio ? "void_ratio" : "porosity"});
    if (!given.is_null()) return given;
    const json other = look_up(echo, {"materials", material, as_ratio ? "porosity" : "void_ratio"});
    if (!other.is_number()) return nullptr;
    const double x = other.get<double>();
    return as_ratio ? x / (1 - x) : x / (1 + x);
  }

  void check_number(const std::string& region, const std::string& name, const char* key, const json& now,
                    const json& before) {
    const bool both = now.is_number() && before.is_number();
    if (both ? std::abs(now.get<double>() - before.get<double>()) <= 1e-12 * std::abs(now.get<double>())
             : now == before)
      return;
    findings_.add(fmt::format("materials.{}.{}", name, key),
                  "'{}' of material '{}' is {}, but the masses are those of {}, where region '{}' was given {}", key,
                  name, now.dump(), result_, region, before.dump());
  }

  const json& now_;
  const json& before_;
  std::string result_;
  Findings& findings_;
};

}  // namespace

void check_against_result(const LoadedCase& loaded, const JsonTree& echo) {
  const json& input = echo.get();
  Places places = loaded.places;
  Findings findings(places);
  Comparison(loaded, input, findings).check();
  if (!findings.empty()) throw InputError(findings.sort());
}

// Checks of [initial] result and stress: the folder of results must exist, and keys that it replaces must not be given.

void check_result(const Case& data, Findings& findings) {
  namespace fs = std::filesystem;
  const Initial& initial = data.initial;
  const std::string path = "initial.result";
  if (initial.result.empty() || !findings.is_sound(path)) return;
  const fs::path folder(initial.result_folder);
  if (!fs::exists(folder))
    findings.add(path, "the folder of results '{}' does not exist", folder.string());
  else if (!fs::is_directory(folder))
    findings.add(path, "'{}' is a file; 'result' names a folder of results", folder.string());
  else if (!fs::exists(folder / "end_state.h5"))
    findings.add(path, "there is no end_state.h5 in '{}': was its run finished, and by this version?", folder.string());
  if (findings.places.is_given("initial.velocity") && findings.is_sound("initial.velocity"))
    findings.add("initial.velocity", "'velocity' in [initial] has no meaning where 'result' is given");
  if (!data.stages.empty() && data.stages.front().gravity_ramp > 0 && findings.is_sound("stage.0.gravity_ramp"))
    findings.add("stage.0.gravity_ramp",
                 "'gravity_ramp' has no meaning in the first stage of a case that starts from a result: gravity acts "
                 "there already");
  const std::string meshes = "strength_reduction.frozen.meshes";
  if (data.strength_reduction.frozen.meshes > 1 && findings.is_sound(meshes))
    findings.add(meshes,
                 "'meshes' is {}, but the mesh of the result that the case starts from cannot be halved; leave it out, "
                 "or write 1",
                 data.strength_reduction.frozen.meshes);
}

void check_start_stress(const Case& data, Findings& findings) {
  if (data.initial.stress != InitialStress::elements || !findings.is_sound("initial.stress")) return;
  if (data.mesh.dimension != 2)
    findings.add("initial.stress", "the initial stress by FEM needs a plane section; write \"k0\"");
}

}  // namespace talus::input
