// SPDX-License-Identifier: MIT
#pragma once
// How dates, series in time and curves over suction are written in TOML: pairs whose two numbers have different units.

#include "input/language/codec.hpp"

namespace talus::input {

/// Rows of two numbers, each with the unit and range of its column.
bool decode_pairs(const Decoding& in, const toml::node& node, const std::string& path, const Spec& first,
                  const Spec& second, const std::string& wanted, std::vector<std::array<double, 2>>& out);
nlohmann::json write_pair_schema(const Spec& first, const Spec& second);

template <>
struct Codec<Series> {
  static bool decode(const Decoding& in, const toml::node& node, const std::string& path, Series& out);
  static nlohmann::json encode(const Series& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

template <>
struct Codec<Date> {
  static bool decode(const Decoding& in, const toml::node& node, const std::string& path, Date& out);
  static nlohmann::json encode(const Date& value, const Spec& spec);
  static std::string name(const Spec&) { return "date"; }
  static nlohmann::json schema(const Spec& spec);
};

template <>
struct Codec<std::vector<Date>> {
  static bool decode(const Decoding& in, const toml::node& node, const std::string& path, std::vector<Date>& out);
  static nlohmann::json encode(const std::vector<Date>& value, const Spec& spec);
  static std::string name(const Spec&) { return "list of dates"; }
  static nlohmann::json schema(const Spec& spec);
};

template <>
struct Codec<SuctionCurve> {
  static bool decode(const Decoding& in, const toml::node& node, const std::string& path, SuctionCurve& out);
  static nlohmann::json encode(const SuctionCurve& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

}  // namespace talus::input
