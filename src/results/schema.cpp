// SPDX-License-Identifier: MIT
// JSON Schema of the results, and their table for the manual.
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "results/json.hpp"
#include "results/laboratory.hpp"
#include "results/run.hpp"
#include "results/study.hpp"

namespace talus::results {
namespace {

using nlohmann::json;

json write_type_schema(const Type& type, json& types, bool can_be_nan = false);

/// Writes the JSON Schema of a struct; `types` collects the structs and enumerations that it contains. Member structs
/// are visited in their default state.
class SchemaWriter : public Visitor {
 public:
  explicit SchemaWriter(json& types) : types_(types) {}

  json properties = json::object(), required = json::array();

 protected:
  void visit(const Key& key, Value value) override {
    const bool is_always = key.presence != Presence::if_given;
    json schema = write_type_schema(is_always ? *value.type : *value.type->inner, types_, key.about.can_be_nan);
    // Beside a reference the generator of the page's types would describe a second type.
    if (schema.contains("$ref")) schema = {{"allOf", json::array({schema})}};
    schema["description"] = *key.about.unit == '\0' ? std::string(key.about.title)
                                                    : fmt::format("{} [{}]", key.about.title, key.about.unit);
    properties[key.name] = std::move(schema);
    if (is_always) required.push_back(key.name);
  }
  void visit_merged(const char* /*sign*/, Value block) override {
    const Type& type = *block.type->inner;
    type.describe(*this, type.make().get());
  }

 private:
  json& types_;
};

json write_null_or(json schema) {
  return {{"anyOf", json::array({std::move(schema), json{{"type", "null"}}})}};
}

json write_structure(const Type& type, json& types) {
  SchemaWriter writer(types);
  type.describe(writer, type.make().get());
  return {{"type", "object"},
          {"additionalProperties", false},
          {"required", std::move(writer.required)},
          {"properties", std::move(writer.properties)}};
}

json write_words(const Type& type) {
  json list = json::array();
  for (std::size_t i = 0; i < type.word_count; ++i) list.push_back(type.words[i]);
  return {{"enum", std::move(list)}};
}

json write_type_schema(const Type& type, json& types, bool can_be_nan) {
  switch (type.shape) {
    case Shape::boolean:
      return {{"type", "boolean"}};
    case Shape::integer:
      return {{"type", "integer"}};
    case Shape::number:
      // NaN is written as null. The page expects it only where the description says so.
      return can_be_nan ? write_null_or({{"type", "number"}}) : json{{"type", json::array({"number", "null"})}};
    case Shape::text:
      return {{"type", "string"}};
    case Shape::tree:
      return {{"type", "object"}};
    case Shape::optional:
      return write_null_or(write_type_schema(*type.inner, types));
    case Shape::list:
      return {{"type", "array"}, {"items", write_type_schema(*type.inner, types, can_be_nan)}};
    case Shape::array: {
      const std::size_t size = type.get_size(nullptr);
      return {
          {"type", "array"}, {"items", write_type_schema(*type.inner, types)}, {"minItems", size}, {"maxItems", size}};
    }
    case Shape::map:
      return {{"type", "object"}, {"additionalProperties", write_type_schema(*type.inner, types, can_be_nan)}};
    case Shape::word:
    case Shape::structure:
      break;
  }
  const std::string name(type.name);
  if (!types.contains(name)) types[name] = type.shape == Shape::word ? write_words(type) : write_structure(type, types);
  return {{"$ref", "#/$defs/" + name}};
}

/// Writes a schema with one line for each property, so that a change shows where it is.
std::string write_lines(const std::string& name, const json& schema) {
  std::string text;
  json head = schema;
  const json properties = head.value("properties", json::object());
  head.erase("properties");
  for (const auto& [key, property] : properties.items())
    text += fmt::format("{}\n  {}: {}", text.empty() ? "" : ",", json(key).dump(), property.dump());
  std::string start = head.dump();
  if (!text.empty()) start.replace(start.size() - 1, 1, ",\"properties\":{" + text + "}}");
  return fmt::format("{}: {}", json(name).dump(), start);
}

/// Writes one table row for each key, followed by the rows of the struct that it contains, through optionals, lists and
/// maps.
class TableWriter : public Visitor {
 public:
  explicit TableWriter(std::string& text, std::string path = "") : text_(text), path_(std::move(path)) {}

 protected:
  void visit(const Key& key, Value value) override {
    std::string path = path_.empty() ? key.name : path_ + "." + key.name;
    text_ += fmt::format("| `{}` | {} | {} |\n", path, key.about.unit, key.about.title);
    const Type* type = value.type;
    const char* mark = "";  // of the outermost list
    while (type->inner != nullptr) {
      if (*mark == '\0' && type->shape != Shape::optional) mark = type->shape == Shape::map ? ".NAME" : "[]";
      type = type->inner;
    }
    if (type->shape != Shape::structure) return;
    TableWriter inner(text_, path + mark);
    type->describe(inner, type->make().get());
  }
  void visit_merged(const char* /*sign*/, Value block) override {
    const Type& type = *block.type->inner;
    type.describe(*this, type.make().get());
  }

 private:
  std::string& text_;
  std::string path_;
};

}  // namespace

std::string write_schema() {
  json types = json::object();
  const json root = write_type_schema(type<RunResult>, types);
  for (const Type* file : {&type<StudyResult>, &type<PointTests>, &type<Calibration>}) write_type_schema(*file, types);
  std::vector<std::string> lines;
  for (const auto& [name, schema] : types.items()) lines.push_back(write_lines(name, schema));
  return fmt::format(
      "{{\n\"$schema\": \"https://json-schema.org/draft/2020-12/schema\",\n\"title\": \"summary.json of Talus\",\n"
      "\"$ref\": {},\n\"$defs\": {{\n{}\n}}\n}}\n",
      root.at("$ref").dump(), fmt::join(lines, ",\n"));
}

std::string write_manual() {
  std::string text = "| key | unit | what it is |\n|---|---|---|\n";
  TableWriter writer(text);
  RunResult run;
  describe(writer, run);
  return text;
}

}  // namespace talus::results
