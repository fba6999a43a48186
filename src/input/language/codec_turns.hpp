// SPDX-License-Identifier: MIT
#pragma once
// How the path of an element test and its changes of a material are written in TOML.

#include "input/language/codec.hpp"

namespace talus::input {

template <>
struct Codec<Turns> {
  static bool decode(const Decoding& in, const toml::node& node, const std::string& path, Turns& out);
  static nlohmann::json encode(const Turns& value, const Spec& spec);
  static std::string name(const Spec& spec);
  static nlohmann::json schema(const Spec& spec);
};

/// A table of keys of the test's material: { cohesion = 5, water.conductivity = 1e-6 }.
template <>
struct Codec<std::vector<PointSetting>> {
  static bool decode(const Decoding& in, const toml::node& node, const std::string& path,
                     std::vector<PointSetting>& out);
  static nlohmann::json encode(const std::vector<PointSetting>& value, const Spec& spec);
  static std::string name(const Spec&) { return "table of keys and values"; }
  static nlohmann::json schema(const Spec&) { return {{"type", "object"}}; }
};

}  // namespace talus::input
