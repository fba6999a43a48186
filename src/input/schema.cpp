// SPDX-License-Identifier: MIT
// `talus schema`: JSON Schema of case files, for the completion and checks of editors.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "input/catalogue.hpp"
#include "input/read.hpp"

namespace talus::input {
namespace {

using nlohmann::json;

std::string write_description(const KeyEntry& key) {
  std::string text = key.meaning;
  for (const auto& [word, meaning] : key.words) text += fmt::format(" {}: {}.", word, meaning);
  if (!key.spec.unit.empty()) text += " Unit of plain numbers: " + key.spec.unit + ".";
  if (key.spec.usual_range) text += " Usually " + key.spec.write_usual_range() + ".";
  if (key.spec.condition) text += " Only where " + write_condition(*key.spec.condition) + ".";
  return text;
}

json write_key_schema(const KeyEntry& key) {
  json schema = key.schema.get();
  schema["description"] = write_description(key);
  if (!key.default_text.empty()) {
    // Defaults are TOML texts of numbers, words and lists, all of which are JSON as well.
    const json value = json::parse(key.default_text, nullptr, false);
    if (!value.is_discarded()) schema["default"] = value;
  }
  return schema;
}

json write_block_schema(const BlockEntry& block);

/// `if fix = "plane" then normal is required`, as the schema says it.
json write_requirement(const KeyEntry& key) {
  const Condition& condition = *key.spec.condition;
  const json then = {{"required", json::array({key.name})}};
  if (condition.is_absence())
    return {{"if", {{"not", {{"required", json::array({condition.any.front().key})}}}}}, {"then", then}};
  json cases = json::array();
  for (const Alternative& a : condition.any)
    cases.push_back({{"properties", {{a.key, {{"const", json::parse(a.value)}}}}}, {"required", json::array({a.key})}});
  return {{"if", cases.size() == 1 ? cases.front() : json{{"anyOf", cases}}}, {"then", then}};
}

/// The object of keys and inner blocks; additional ones are refused, as the reader does.
json write_object(const BlockEntry& block) {
  json object = {{"type", "object"}, {"additionalProperties", false}, {"properties", json::object()}};
  json required = json::array(), all_of = json::array();
  for (const KeyEntry& key : block.keys) {
    object["properties"][key.name] = write_key_schema(key);
    // What depends on the methods or on another table cannot be said here; the reader checks it.
    const bool has_waivers = !key.spec.methods.empty() || key.spec.instead;
    if (key.spec.is_required && !has_waivers) required.push_back(key.name);
    if (const auto& condition = key.spec.condition;
        condition && condition->required && !has_waivers && condition->any.front().key.find('.') == std::string::npos)
      all_of.push_back(write_requirement(key));
  }
  for (const BlockEntry& inner : block.blocks) object["properties"][inner.key] = write_block_schema(inner);
  if (!required.empty()) object["required"] = required;
  if (!all_of.empty()) object["allOf"] = all_of;
  return object;
}

json write_block_schema(const BlockEntry& block) {
  json schema;
  switch (block.kind) {
    case BlockKind::table:
      schema = write_object(block);
      break;
    case BlockKind::list:
      schema = {{"type", "array"}, {"items", write_object(block)}};
      break;
    case BlockKind::named:
      schema = {{"type", "object"}, {"additionalProperties", write_object(block)}};
      break;
    case BlockKind::entries:
      schema = {{"type", "object"}, {"additionalProperties", write_key_schema(block.keys.front())}};
      break;
  }
  schema["description"] = block.meaning;
  return schema;
}

}  // namespace

json write_schema() {
  json schema = write_object(collect_catalogue());
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "Talus case file";
  schema["required"] = json::array({"materials", "regions"});
  // Stages are those of the material point method.
  const json no_points = {{"not", {{"contains", {{"const", "mpm"}}}}}};
  const json asks = {{"required", {"methods"}}, {"properties", {{"methods", no_points}}}};
  schema["if"] = {{"required", {"analysis"}}, {"properties", {{"analysis", asks}}}};
  schema["else"] = {{"required", {"stage"}}};
  return schema;
}

}  // namespace talus::input
