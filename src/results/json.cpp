// SPDX-License-Identifier: MIT
#include "results/json.hpp"

#include <fmt/ranges.h>

#include "base/atomic_file.hpp"
#include "base/user_file.hpp"
#include "results/construction_restart.hpp"
#include "results/flow_restart.hpp"
#include "results/json_visitors.hpp"
#include "results/laboratory.hpp"
#include "results/present.hpp"
#include "results/run.hpp"
#include "results/study.hpp"

namespace talus::results {

template <class T>
nlohmann::json to_json(const T& result) {
  return write_value(result);
}

template <class T>
T from_json(const nlohmann::json& tree, const std::string& file) {
  T result{};
  read_value(tree, result, JsonPlace(file));
  return result;
}

template <class T>
std::optional<T> read_file(const std::filesystem::path& path) {
  std::string text;
  if (const auto fault = try_user_file(path, largest_file::result, text)) {
    if (fault->is_missing) return std::nullopt;
    fail_input("cannot read '{}': {}", path.string(), fault->why);
  }
  nlohmann::json tree;
  try {
    tree = nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    fail_input("cannot read '{}': {}", path.string(), error.what());
  }
  if constexpr (!is_vector<T>)
    if (!tree.is_object()) fail_input("'{}' is no result of Talus: it should hold one JSON object", path.string());
  if constexpr (requires(T result) { result.format; })
    if (const auto found = tree.find("format"); found == tree.end() || *found != result_format)
      fail_input("'{}' was written by another version of Talus (result format {}, this is {}): run the case again",
                 path.string(), found == tree.end() ? std::string("1") : found->dump(), result_format);
  return from_json<T>(tree, path.string());
}

template <class T>
std::optional<T> find_file(const std::filesystem::path& path) {
  try {
    return read_file<T>(path);
  } catch (const Error&) {
    return std::nullopt;
  }
}

template <class T>
void write_file(const std::filesystem::path& path, const T& result, int indent, const std::string& safe) {
  write_atomically(path, to_json(result).dump(indent) + "\n", safe);
}

#define TALUS_JSON(T)                                                   \
  template nlohmann::json to_json<T>(const T&);                         \
  template T from_json<T>(const nlohmann::json&, const std::string&);   \
  template std::optional<T> read_file<T>(const std::filesystem::path&); \
  template std::optional<T> find_file<T>(const std::filesystem::path&); \
  template void write_file<T>(const std::filesystem::path&, const T&, int, const std::string&);
TALUS_JSON(RunResult)
TALUS_JSON(SliceFile)
TALUS_JSON(TimelineFile)
TALUS_JSON(ConstructionFile)
TALUS_JSON(ConstructionRestart)
TALUS_JSON(ElementFile)
TALUS_JSON(PresentReduction)
TALUS_JSON(ElementTrial)
TALUS_JSON(BoundsFile)
TALUS_JSON(FlowFile)
TALUS_JSON(FlowRestart)
TALUS_JSON(WaterFields)
TALUS_JSON(Trial)
TALUS_JSON(std::vector<Trial>)
TALUS_JSON(SlipLine)
TALUS_JSON(TrialOutcome)
TALUS_JSON(StageRecord)
TALUS_JSON(StudyResult)
TALUS_JSON(StudyJobs)
TALUS_JSON(JobSurfaces)
TALUS_JSON(JobResult)
TALUS_JSON(PointTests)
TALUS_JSON(Calibration)
#undef TALUS_JSON

// Parts of the results of a variant that the page of a study shows.
#define TALUS_JSON(T) template nlohmann::json to_json<T>(const T&);
TALUS_JSON(Motion)
TALUS_JSON(DisplacementCurve)
#undef TALUS_JSON

namespace {

using nlohmann::json;

/// Returns the name of the type T without its namespace.
template <class T>
std::string name_type() {
  const std::string_view text = __PRETTY_FUNCTION__;  // "… [with T = talus::results::Circle; …]"
  const std::size_t from = text.find("T = ") + 4;
  const std::string_view name = text.substr(from, text.find_first_of(";]", from) - from);
  return std::string(name.substr(name.rfind(':') + 1));
}

template <class T>
json write_type_schema(json& types, bool can_be_nan = false);

/// Writes the JSON Schema of a struct; `types` collects the structs and enumerations that it contains. Member structs
/// are visited in their default state.
class SchemaWriter {
 public:
  explicit SchemaWriter(json& types) : types_(types) {}

  template <class T>
  void key(const char* name, const T& /*member*/, const About& about) {
    add<T>(name, about);
    required.push_back(name);
  }
  template <class T>
  void maybe(const char* name, const std::optional<T>& /*member*/, const About& about) {
    add<T>(name, about);
  }
  void derived(const char* name, const auto& value, const About& about) { key(name, value, about); }
  template <class T>
  void merge(const char* /*sign*/, const std::optional<T>& /*block*/) {
    T block{};
    describe(*this, block);
  }

  json properties = json::object(), required = json::array();

 private:
  template <class T>
  void add(const char* name, const About& about) {
    json schema = write_type_schema<T>(types_, about.can_be_nan);
    // Beside a reference the generator of the page's types would describe a second type.
    if (schema.contains("$ref")) schema = {{"allOf", json::array({schema})}};
    schema["description"] =
        *about.unit == '\0' ? std::string(about.title) : fmt::format("{} [{}]", about.title, about.unit);
    properties[name] = std::move(schema);
  }

  json& types_;
};

json write_null_or(json schema) {
  return {{"anyOf", json::array({std::move(schema), json{{"type", "null"}}})}};
}

/// Writes the schema of an enumeration or a struct.
template <class T>
json write_definition(json& types) {
  if constexpr (std::is_enum_v<T>) {
    json list = json::array();
    for (const char* word : words<T>) list.push_back(word);
    return {{"enum", std::move(list)}};
  } else {
    SchemaWriter writer(types);
    T block{};
    describe(writer, block);
    return {{"type", "object"},
            {"additionalProperties", false},
            {"required", std::move(writer.required)},
            {"properties", std::move(writer.properties)}};
  }
}

template <class T>
json write_type_schema(json& types, bool can_be_nan) {
  if constexpr (std::is_same_v<T, JsonTree>) {
    return {{"type", "object"}};
  } else if constexpr (std::is_same_v<T, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::is_integral_v<T>) {
    return {{"type", "integer"}};
  } else if constexpr (std::is_floating_point_v<T>) {
    // NaN is written as null. The page expects it only where the description says so.
    return can_be_nan ? write_null_or({{"type", "number"}}) : json{{"type", json::array({"number", "null"})}};
  } else if constexpr (std::is_same_v<T, std::string>) {
    return {{"type", "string"}};
  } else if constexpr (is_optional<T>) {
    return write_null_or(write_type_schema<typename T::value_type>(types));
  } else if constexpr (is_vector<T>) {
    return {{"type", "array"}, {"items", write_type_schema<typename T::value_type>(types, can_be_nan)}};
  } else if constexpr (is_array<T>) {
    constexpr std::size_t size = std::tuple_size_v<T>;
    return {{"type", "array"},
            {"items", write_type_schema<typename T::value_type>(types)},
            {"minItems", size},
            {"maxItems", size}};
  } else if constexpr (is_map<T>) {
    return {{"type", "object"},
            {"additionalProperties", write_type_schema<typename T::mapped_type>(types, can_be_nan)}};
  } else {
    const std::string name = name_type<T>();
    if (!types.contains(name)) types[name] = write_definition<T>(types);
    return {{"$ref", "#/$defs/" + name}};
  }
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

/// The struct type that a member contains, through optionals, lists and maps; void if it contains none.
template <class T>
struct Inner {
  using Type = std::conditional_t<std::is_class_v<T> && !std::is_same_v<T, std::string> && !std::is_same_v<T, JsonTree>,
                                  T, void>;
  static constexpr const char* mark = "";
};
template <class T>
struct Inner<std::optional<T>> : Inner<T> {};
template <class T>
struct Inner<std::vector<T>> {
  using Type = typename Inner<T>::Type;
  static constexpr const char* mark = "[]";
};
template <class T, std::size_t N>
struct Inner<std::array<T, N>> {
  using Type = typename Inner<T>::Type;
  static constexpr const char* mark = "[]";
};
template <class T>
struct Inner<std::map<std::string, T>> {
  using Type = typename Inner<T>::Type;
  static constexpr const char* mark = ".NAME";
};

/// Writes one table row for each key, followed by the rows of the struct that it contains.
class TableWriter {
 public:
  explicit TableWriter(std::string& text, std::string path = "") : text_(text), path_(std::move(path)) {}

  template <class T>
  void key(const char* name, const T& /*member*/, const About& about) {
    const std::string path = path_.empty() ? name : path_ + "." + name;
    text_ += fmt::format("| `{}` | {} | {} |\n", path, *about.unit == '\0' ? "" : about.unit, about.title);
    using Held = typename Inner<T>::Type;
    if constexpr (!std::is_void_v<Held>) {
      TableWriter inner(text_, path + Inner<T>::mark);
      Held held{};
      describe(inner, held);
    }
  }
  template <class T>
  void maybe(const char* name, const std::optional<T>& /*member*/, const About& about) {
    key(name, T{}, about);
  }
  void derived(const char* name, const auto& value, const About& about) { key(name, value, about); }
  template <class T>
  void merge(const char* /*sign*/, const std::optional<T>& /*block*/) {
    T block{};
    describe(*this, block);
  }

 private:
  std::string& text_;
  std::string path_;
};

}  // namespace

std::string write_schema() {
  json types = json::object();
  const json root = write_type_schema<RunResult>(types);
  write_type_schema<StudyResult>(types);
  write_type_schema<PointTests>(types);
  write_type_schema<Calibration>(types);
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
