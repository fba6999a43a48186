// SPDX-License-Identifier: MIT
// Questions to an echo without reading it into a case: whether two agree, and what they are called.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/hash.hpp"
#include "input/case/material.hpp"
#include "input/echo.hpp"

namespace talus::input {
namespace {

using nlohmann::json;

json strip_marks(json node) {
  if (node.is_object()) node.erase("given");
  if (node.is_structured())
    for (json& inner : node) inner = strip_marks(inner);
  return node;
}

/// What a mesh was made from.
json describe_mesh_input(const json& echo) {
  json mesh = strip_marks(echo.at("mesh"));
  mesh.erase("points_per_element");
  // The path of a ready mesh is the one from where the program was started.
  if (mesh.contains("file"))
    mesh["file"] = std::filesystem::path(mesh["file"].at("value").get<std::string>()).filename().string();
  return {strip_marks(echo.at("geometry")), mesh};
}

}  // namespace

std::string hash_input(const JsonTree& tree) {
  json echo = tree.get();
  for (const char* block : {"output", "project", "compare"}) echo.erase(block);
  const std::function<void(json&)> strip = [&](json& node) {
    if (node.is_object()) node.erase("courant");
    if (node.is_structured()) std::for_each(node.begin(), node.end(), strip);
  };
  strip(echo);
  return hash_text(echo.dump());
}

bool has_same_mesh_input(const JsonTree& a, const JsonTree& b) {
  return describe_mesh_input(a.get()) == describe_mesh_input(b.get());
}

JsonTree replace_mesh_input(const JsonTree& echo, const JsonTree& other) {
  json replaced = echo.get();
  for (const char* block : {"geometry", "mesh"}) replaced[block] = other.get().at(block);
  return JsonTree(std::move(replaced));
}

std::vector<MaterialModel> list_material_models(const JsonTree& echo, const std::string& source) {
  std::vector<MaterialModel> models;
  for (const auto& [name, material] : echo.get().at("materials").items()) {
    const std::string word = material.at("model").at("value");
    const auto& words = choices<MaterialModel>;
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto& c) { return c.word == word; });
    if (found == words.end())
      throw Error(ExitCode::wrong_input, fmt::format("the result '{}' has a material of the model '{}', which this "
                                                     "version does not know",
                                                     source, word));
    models.push_back(found->value);
  }
  return models;
}

}  // namespace talus::input
