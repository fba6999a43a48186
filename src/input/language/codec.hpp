// SPDX-License-Identifier: MIT
#pragma once
// Conversion of each C++ type of a key to and from TOML, JSON and JSON Schema. Each type has a specialisation of Codec,
// except enumerations, their lists and optional values, which one conversion serves (visitor.hpp):
//   decode  reads a TOML node into the value (SI units, radians); returns false and adds a finding if it cannot
//   encode  writes the value as JSON in the unit of the manual
//   name    describes the notation: "number", "number [kPa] or text with unit"
//   schema  is the JSON Schema of the notation

#include <toml++/toml.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "input/language/findings.hpp"
#include "input/language/forms.hpp"
#include "input/language/visitor.hpp"

namespace talus::input {

/// A node that is being decoded as the value of a key, or as a part of it.
struct Decoding {
  const Spec& spec;
  std::string key;
  Findings& findings;
  const toml::node& node;
  std::string path;

  /// The same for a part of the node, whose path has one step more.
  Decoding at(const toml::node& part, const std::string& step) const {
    return {spec, key, findings, part, path + "." + step};
  }
  /// The same for the i-th item of a list.
  Decoding item(std::size_t i) const { return at(*node.as_array()->get(i), std::to_string(i)); }
  Decoding with(const Spec& other) const { return {other, key, findings, node, path}; }

  /// Reports `sentence` at the node and returns false.
  bool fail(const std::string& sentence) const;
  template <class First, class... Rest>
  bool fail(fmt::format_string<First, Rest...> sentence, First&& first, Rest&&... rest) const {
    return fail(fmt::format(sentence, std::forward<First>(first), std::forward<Rest>(rest)...));
  }
  /// Reports that the node must be `wanted` ("a number") and returns false.
  bool fail_type(const std::string& wanted) const;
  void record() const;
};

/// Returns the TOML text of a JSON value: 44, "frontal", [0, -1].
std::string write_toml(const nlohmann::json& value);
/// Returns the TOML text of a TOML node.
std::string write_toml(const toml::node& node);

bool decode_number(const Decoding& in, double& out);
bool decode_numbers(const Decoding& in, std::size_t least, std::size_t most, const std::string& wanted,
                    std::vector<double>& out);
bool decode_points(const Decoding& in, std::vector<std::array<double, 2>>& out);
bool decode_word(const Decoding& in, const std::vector<std::string>& words, std::size_t& out);
/// Returns `si` in the unit of `spec`, rounded to remove conversion errors.
nlohmann::json encode_number(double si, const Spec& spec);
/// Returns a list of what encode(value) returns for each of `values`.
nlohmann::json encode_list(const auto& values, const auto& encode) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& value : values) list.push_back(encode(value));
  return list;
}
nlohmann::json encode_numbers(const auto& values, const Spec& spec) {
  return encode_list(values, [&](double value) { return encode_number(value, spec); });
}
nlohmann::json write_number_schema(const Spec& spec);
nlohmann::json write_array_schema(const nlohmann::json& items, int least, int most);

template <class T>
struct Codec;

template <>
struct Codec<double> {
  static bool decode(const Decoding& in, double& out) { return decode_number(in, out); }
  static nlohmann::json encode(double value, const Spec& spec) { return encode_number(value, spec); }
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec) { return write_number_schema(spec); }
};

template <>
struct Codec<int> {
  static bool decode(const Decoding& in, int& out);
  static nlohmann::json encode(int value, const Spec&) { return value; }
  static std::string name(const Spec&) { return "whole number"; }
  static nlohmann::json schema(const Spec& spec);
};

template <>
struct Codec<bool> {
  static bool decode(const Decoding& in, bool& out);
  static nlohmann::json encode(bool value, const Spec&) { return value; }
  static std::string name(const Spec&) { return "true or false"; }
  static nlohmann::json schema(const Spec&) { return {{"type", "boolean"}}; }
};

template <>
struct Codec<std::string> {
  static bool decode(const Decoding& in, std::string& out);
  static nlohmann::json encode(const std::string& value, const Spec&) { return value; }
  static std::string name(const Spec&) { return "text"; }
  static nlohmann::json schema(const Spec&) { return {{"type", "string"}}; }
};

/// A vector of two components (the third is zero) or three.
template <>
struct Codec<std::array<double, 3>> {
  static bool decode(const Decoding& in, std::array<double, 3>& out);
  static nlohmann::json encode(const std::array<double, 3>& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec) { return write_array_schema(write_number_schema(spec), 2, 3); }
};

template <>
struct Codec<std::vector<double>> {
  static bool decode(const Decoding& in, std::vector<double>& out) {
    return decode_numbers(in, 0, std::size_t(-1), "a list of numbers", out);
  }
  static nlohmann::json encode(const std::vector<double>& value, const Spec& spec) {
    return encode_numbers(value, spec);
  }
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec) { return write_array_schema(write_number_schema(spec), 0, -1); }
};

/// Points in the plane: [[x, y], ...].
template <>
struct Codec<std::vector<std::array<double, 2>>> {
  using Points = std::vector<std::array<double, 2>>;
  static bool decode(const Decoding& in, Points& out) { return decode_points(in, out); }
  static nlohmann::json encode(const Points& value, const Spec& spec) {
    return encode_list(value, [&](const auto& point) { return encode_numbers(point, spec); });
  }
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

template <>
struct Codec<Corners> {
  static bool decode(const Decoding& in, Corners& out);
  static nlohmann::json encode(const Corners& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

/// A factor over time: [[time, factor], ...]; the unit of the key is the unit of time.
template <>
struct Codec<TimeTable> {
  static bool decode(const Decoding& in, TimeTable& out);
  static nlohmann::json encode(const TimeTable& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

/// A number, or a text of a number and a unit of any dimension.
template <>
struct Codec<Amount> {
  static bool decode(const Decoding& in, Amount& out);
  static nlohmann::json encode(const Amount& value, const Spec& spec);
  static std::string name(const Spec&) { return "number or text with unit"; }
  static nlohmann::json schema(const Spec&) { return {{"type", {"number", "string"}}}; }
};

template <>
struct Codec<TomlTexts> {
  static bool decode(const Decoding& in, TomlTexts& out);
  static nlohmann::json encode(const TomlTexts& value, const Spec&) { return value.texts; }
  static std::string name(const Spec&) { return "list of values"; }
  static nlohmann::json schema(const Spec&) { return {{"type", "array"}, {"minItems", 1}}; }
};

}  // namespace talus::input
