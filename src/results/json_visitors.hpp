// SPDX-License-Identifier: MIT
#pragma once
// Visitors that convert described structs to JSON and back. Only results/json*.cpp includes this header.

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/error.hpp"
#include "base/json_tree.hpp"
#include "results/about.hpp"
#include "results/shapes.hpp"

namespace talus::results {

template <class T>
nlohmann::json write_value(const T& value);

/// Writes a struct as an object.
class JsonWriter {
 public:
  void key(const char* name, const auto& member, const About& /*about*/) { object[name] = write_value(member); }
  template <class T>
  void maybe(const char* name, const std::optional<T>& member, const About& about) {
    if (member) key(name, *member, about);
  }
  /// Writes a value that follows from other members; readers ignore it.
  void derived(const char* name, const auto& value, const About& about) { key(name, value, about); }

  /// Writes the keys of a block beside those of its owner.
  template <class T>
  void merge(const char* /*sign*/, const std::optional<T>& block) {
    if (block) describe(*this, *block);
  }

  nlohmann::json object = nlohmann::json::object();
};

template <class T>
nlohmann::json write_value(const T& value) {
  if constexpr (std::is_same_v<T, JsonTree>) {
    return value.get();
  } else if constexpr (std::is_enum_v<T>) {
    return to_word(value);
  } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
    return value;
  } else if constexpr (is_optional<T>) {
    return value ? write_value(*value) : nlohmann::json();
  } else if constexpr (is_vector<T> || is_array<T>) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& entry : value) list.push_back(write_value(entry));
    return list;
  } else if constexpr (is_map<T>) {
    nlohmann::json object = nlohmann::json::object();
    for (const auto& [name, entry] : value) object[name] = write_value(entry);
    return object;
  } else {
    JsonWriter writer;
    describe(writer, value);
    return std::move(writer.object);
  }
}

/// Position of a value as a chain of keys up to the file. It is formatted only for an error message.
class JsonPlace {
 public:
  explicit JsonPlace(const std::string& file) : key_(file) {}
  JsonPlace(const JsonPlace& owner, std::string_view key) : owner_(&owner), key_(key) {}
  JsonPlace(const JsonPlace& owner, std::size_t index) : owner_(&owner), index_(index) {}

  [[noreturn]] void refuse(const char* expected) const {
    fail_input("{} should be {}: it is not as this version writes it", write(), expected);
  }

 private:
  /// Returns a position such as "summary.json: fem.runs[0].factor".
  std::string write() const {
    if (owner_ == nullptr) return std::string(key_);
    if (key_.empty()) return fmt::format("{}[{}]", owner_->write(), index_);
    return fmt::format("{}{}{}", owner_->write(), owner_->owner_ == nullptr ? ": " : ".", key_);
  }

  const JsonPlace* owner_ = nullptr;
  std::string_view key_;
  std::size_t index_ = 0;
};

template <class T>
void read_value(const nlohmann::json& node, T& value, const JsonPlace& place);

/// Reads a struct from an object.
class JsonReader {
 public:
  JsonReader(const nlohmann::json& object, const JsonPlace& place) : object_(object), place_(place) {}

  void key(const char* name, auto& member, const About& /*about*/) {
    const auto found = object_.find(name);
    if (found != object_.end()) read_value(*found, member, JsonPlace(place_, name));
  }
  template <class T>
  void maybe(const char* name, std::optional<T>& member, const About& about) {
    key(name, member, about);
  }
  void derived(const char* /*name*/, const auto& /*value*/, const About& /*about*/) {}
  template <class T>
  void merge(const char* sign, std::optional<T>& block) {
    if (object_.contains(sign)) describe(*this, block.emplace());
  }

 private:
  const nlohmann::json& object_;
  const JsonPlace& place_;
};

template <class T>
void read_value(const nlohmann::json& node, T& value, const JsonPlace& place) {
  if constexpr (std::is_same_v<T, JsonTree>) {
    if (!node.is_object()) place.refuse("an object");
    value = JsonTree(node);
  } else if constexpr (std::is_enum_v<T>) {
    if (!node.is_string()) place.refuse("a word");
    const auto& text = node.get_ref<const std::string&>();
    const std::optional<T> found = from_word<T>(text);
    if (!found) place.refuse("a word that this version knows");
    value = *found;
  } else if constexpr (std::is_same_v<T, bool>) {
    if (!node.is_boolean()) place.refuse("true or false");
    value = node.get<bool>();
  } else if constexpr (std::is_floating_point_v<T>) {
    // non-finite numbers are stored as null
    if (!node.is_number() && !node.is_null()) place.refuse("a number");
    value = node.is_null() ? std::nan("") : node.get<T>();
  } else if constexpr (std::is_integral_v<T>) {
    if (!node.is_number()) place.refuse("a whole number");
    value = node.get<T>();
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (!node.is_string()) place.refuse("a text");
    value = node.get<std::string>();
  } else if constexpr (is_optional<T>) {
    if (node.is_null()) return value.reset();
    read_value(node, value.emplace(), place);
  } else if constexpr (is_vector<T>) {
    if (!node.is_array()) place.refuse("a list");
    value.clear();
    value.reserve(node.size());
    for (std::size_t i = 0; i < node.size(); ++i) read_value(node[i], value.emplace_back(), JsonPlace(place, i));
  } else if constexpr (is_array<T>) {
    if (!node.is_array() || node.size() != value.size()) place.refuse("a list of as many numbers");
    for (std::size_t i = 0; i < value.size(); ++i) read_value(node[i], value[i], JsonPlace(place, i));
  } else if constexpr (is_map<T>) {
    if (!node.is_object()) place.refuse("an object");
    value.clear();
    for (const auto& [name, entry] : node.items()) read_value(entry, value[name], JsonPlace(place, name));
  } else {
    if (!node.is_object()) place.refuse("an object");
    JsonReader reader(node, place);
    describe(reader, value);
  }
}

}  // namespace talus::results
