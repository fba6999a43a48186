// SPDX-License-Identifier: MIT
#pragma once
// How contents in per cent, shares over depth or age, and the four suctions of Feddes are written in TOML.

#include "input/language/codec.hpp"

namespace talus::input {

bool decode_per_cent(const Decoding& in, const toml::node& node, const std::string& path, double& out);

template <class T>
struct Codec<PerCent<T>> {
  static bool decode(const Decoding& in, const toml::node& node, const std::string& path, PerCent<T>& out) {
    double value = 0;
    if (!decode_per_cent(in, node, path, value)) return false;
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
  static bool decode(const Decoding& in, const toml::node& node, const std::string& path, ShareTable& out);
  static nlohmann::json encode(const ShareTable& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

/// Four increasing numbers.
template <>
struct Codec<std::array<double, 4>> {
  static bool decode(const Decoding& in, const toml::node& node, const std::string& path, std::array<double, 4>& out);
  static nlohmann::json encode(const std::array<double, 4>& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec) { return write_array_schema(write_number_schema(spec), 4, 4); }
};

}  // namespace talus::input
