// SPDX-License-Identifier: MIT
#include "results/documents.hpp"

#include <set>

#include "results/json_visitors.hpp"
#include "results/run.hpp"

namespace talus::results {
namespace {

using nlohmann::json;

template <class T>
json write_type_schema();

/// Writes a struct as the schema of an object. What it is made of is visited in its default state.
class SchemaWriter {
 public:
  template <class T>
  void key(const char* name, const T& /*member*/, const About& about) {
    json schema = write_type_schema<T>();
    schema["description"] =
        *about.unit == '\0' ? std::string(about.title) : fmt::format("{} [{}]", about.title, about.unit);
    properties[name] = std::move(schema);
  }
  template <class T>
  void maybe(const char* name, const std::optional<T>& /*member*/, const About& about) {
    key(name, T{}, about);
  }
  template <class T>
  void derived(const char* name, const T& value, const About& about) {
    key(name, value, about);
  }
  template <class T>
  void merge(const char* /*sign*/, const std::optional<T>& /*block*/) {
    T block{};
    describe(*this, block);
  }

  json properties = json::object();
};

template <class T>
json write_type_schema() {
  if constexpr (std::is_same_v<T, JsonTree>) {
    return {{"type", "object"}};
  } else if constexpr (std::is_enum_v<T>) {
    json list = json::array();
    for (const auto& word : words<T>) list.push_back(word.word);
    return {{"enum", list}};
  } else if constexpr (std::is_same_v<T, bool>) {
    return {{"type", "boolean"}};
  } else if constexpr (std::is_integral_v<T>) {
    return {{"type", "integer"}};
  } else if constexpr (std::is_floating_point_v<T>) {
    return {{"type", json::array({"number", "null"})}};  // null: not finite
  } else if constexpr (std::is_same_v<T, std::string>) {
    return {{"type", "string"}};
  } else if constexpr (is_optional<T>) {
    return {{"anyOf", json::array({write_type_schema<typename T::value_type>(), json{{"type", "null"}}})}};
  } else if constexpr (is_vector<T>) {
    return {{"type", "array"}, {"items", write_type_schema<typename T::value_type>()}};
  } else if constexpr (is_array<T>) {
    constexpr std::size_t size = std::tuple_size_v<T>;
    return {{"type", "array"},
            {"items", write_type_schema<typename T::value_type>()},
            {"minItems", size},
            {"maxItems", size}};
  } else if constexpr (is_map<T>) {
    return {{"type", "object"}, {"additionalProperties", write_type_schema<typename T::mapped_type>()}};
  } else {
    SchemaWriter writer;
    T block{};
    describe(writer, block);
    return {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(writer.properties)}};
  }
}

/// The struct that a member holds, through optionals, lists and maps; void for what is no struct.
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

/// Writes a line of a table for each key, and those of what it holds below it.
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
  template <class T>
  void derived(const char* name, const T& value, const About& about) {
    key(name, value, about);
  }
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
  json schema = write_type_schema<RunResult>();
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "summary.json of Talus";
  return schema.dump(2) + "\n";
}

std::string write_manual() {
  std::string text = "| key | unit | what it is |\n|---|---|---|\n";
  TableWriter writer(text);
  RunResult run;
  describe(writer, run);
  return text;
}

}  // namespace talus::results
