// SPDX-License-Identifier: MIT
#pragma once
// Codecs of lists of words and texts, points, large integers, series, tables and single values of any unit.

#include <cstdint>

#include "input/language/codec.hpp"

namespace talus::input {

bool decode_words(const Decoding& in, const std::vector<std::string>& words, std::vector<std::size_t>& out);

template <>
struct Codec<std::vector<std::string>> {
  static bool decode(const Decoding& in, std::vector<std::string>& out);
  static nlohmann::json encode(const std::vector<std::string>& value, const Spec&) { return value; }
  static std::string name(const Spec&) { return "list of texts"; }
  static nlohmann::json schema(const Spec&) { return write_array_schema({{"type", "string"}}, 0, -1); }
};

/// A point in the plane: [x, y].
template <>
struct Codec<std::array<double, 2>> {
  static bool decode(const Decoding& in, std::array<double, 2>& out);
  static nlohmann::json encode(const std::array<double, 2>& value, const Spec& spec) {
    return encode_numbers(value, spec);
  }
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec) { return write_array_schema(write_number_schema(spec), 2, 2); }
};

template <>
struct Codec<std::uint64_t> {
  static bool decode(const Decoding& in, std::uint64_t& out);
  static nlohmann::json encode(std::uint64_t value, const Spec&) { return value; }
  static std::string name(const Spec&) { return "whole number"; }
  static nlohmann::json schema(const Spec&) { return {{"type", "integer"}, {"minimum", 0}}; }
};

template <>
struct Codec<TomlText> {
  static bool decode(const Decoding& in, TomlText& out);
  static nlohmann::json encode(const TomlText& value, const Spec&);
  static std::string name(const Spec&) { return "number or text with unit"; }
  static nlohmann::json schema(const Spec&) { return {{"type", {"number", "string"}}}; }
};

// Codecs of dates, series in time and curves over suction, i.e. pairs whose two numbers have different units.

/// Decodes rows of two numbers, each with the unit and range of its column.
bool decode_pairs(const Decoding& in, const Spec& first, const Spec& second, const std::string& wanted,
                  std::vector<std::array<double, 2>>& out);
nlohmann::json write_pair_schema(const Spec& first, const Spec& second);

template <>
struct Codec<Series> {
  static bool decode(const Decoding& in, Series& out);
  static nlohmann::json encode(const Series& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

template <>
struct Codec<SurveyPoints> {
  static bool decode(const Decoding& in, SurveyPoints& out);
  static nlohmann::json encode(const SurveyPoints& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

template <>
struct Codec<Date> {
  static bool decode(const Decoding& in, Date& out);
  static nlohmann::json encode(const Date& value, const Spec& spec);
  static std::string name(const Spec&) { return "date"; }
  static nlohmann::json schema(const Spec& spec);
};

template <>
struct Codec<std::vector<Date>> {
  static bool decode(const Decoding& in, std::vector<Date>& out);
  static nlohmann::json encode(const std::vector<Date>& value, const Spec& spec);
  static std::string name(const Spec&) { return "list of dates"; }
  static nlohmann::json schema(const Spec& spec);
};

template <>
struct Codec<SuctionCurve> {
  static bool decode(const Decoding& in, SuctionCurve& out);
  static nlohmann::json encode(const SuctionCurve& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

// Codecs of contents in per cent, fractions over depth or age, and the four suctions of Feddes.

bool decode_per_cent(const Decoding& in, double& out);

template <class T>
struct Codec<PerCent<T>> {
  static bool decode(const Decoding& in, PerCent<T>& out) {
    double value = 0;
    if (!decode_per_cent(in, value)) return false;
    out.value = value;
    return true;
  }
  static nlohmann::json encode(const PerCent<T>& value, const Spec&) {
    const std::optional<double> number = value.value;
    return number ? nlohmann::json(*number) : nlohmann::json();
  }
  static std::string name(const Spec& spec) { return Codec<double>::name(spec); }
  static nlohmann::json schema(const Spec& spec) { return write_number_schema(spec); }
};

template <>
struct Codec<ShareTable> {
  static bool decode(const Decoding& in, ShareTable& out);
  static nlohmann::json encode(const ShareTable& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

/// Four increasing numbers.
template <>
struct Codec<std::array<double, 4>> {
  static bool decode(const Decoding& in, std::array<double, 4>& out);
  static nlohmann::json encode(const std::array<double, 4>& value, const Spec& spec) {
    return encode_numbers(value, spec);
  }
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec) { return write_array_schema(write_number_schema(spec), 4, 4); }
};

// Codecs of the path of an element test and its changes of a material.

template <>
struct Codec<Turns> {
  static bool decode(const Decoding& in, Turns& out);
  static nlohmann::json encode(const Turns& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

/// A table of keys of the test's material: { cohesion = 5, water.conductivity = 1e-6 }.
template <>
struct Codec<std::vector<PointSetting>> {
  static bool decode(const Decoding& in, std::vector<PointSetting>& out);
  static nlohmann::json encode(const std::vector<PointSetting>& value, const Spec& spec);
  static std::string name(const Spec&) { return "table of keys and values"; }
  static nlohmann::json schema(const Spec&) { return {{"type", "object"}}; }
};

}  // namespace talus::input

// All codecs, for visitors of the whole case.
