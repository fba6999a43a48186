// SPDX-License-Identifier: MIT
#include "input/language/codec_turns.hpp"

#include <fmt/format.h>

namespace talus::input {
namespace {

using nlohmann::json;

void collect(const toml::table& table, const std::string& prefix, std::vector<PointSetting>& out) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const toml::table* inner = node.as_table())
      collect(*inner, name + ".", out);
    else
      out.push_back({name, write_toml(node)});
  }
}

}  // namespace

bool Codec<Turns>::decode(const Decoding& in, const toml::node& node, const std::string& path, Turns& out) {
  if (node.is_array())
    return decode_numbers(in, node, path, 1, std::size_t(-1), "a number or a list of at least one number", out.values);
  double value = 0;
  if (!decode_number(in, node, path, value)) return false;
  out.values = {value};
  return true;
}

json Codec<Turns>::encode(const Turns& value, const Spec& spec) {
  if (value.values.empty()) return {};
  if (value.values.size() == 1) return encode_number(value.values[0], spec);
  return Codec<std::vector<double>>::encode(value.values, spec);
}

std::string Codec<Turns>::name(const Spec& spec) {
  return spec.unit.empty() ? "number or list of numbers" : fmt::format("number or list of numbers [{}]", spec.unit);
}

json Codec<Turns>::schema(const Spec& spec) {
  const json number = write_number_schema(spec);
  json choices = number.contains("anyOf") ? number["anyOf"] : json::array({number});
  choices.push_back(write_array_schema(number, 1, -1));
  return {{"anyOf", choices}};
}

bool Codec<std::vector<PointSetting>>::decode(const Decoding& in, const toml::node& node, const std::string& path,
                                              std::vector<PointSetting>& out) {
  const toml::table* table = node.as_table();
  if (table == nullptr) return in.fail_type(node, path, "a table of the material's keys, such as { porosity = 0.4 }");
  in.record(node, path);
  out.clear();
  collect(*table, "", out);
  return true;
}

json Codec<std::vector<PointSetting>>::encode(const std::vector<PointSetting>& value, const Spec&) {
  if (value.empty()) return {};
  std::string text;
  for (const PointSetting& s : value) text += (text.empty() ? "" : ", ") + s.key + " = " + s.value;
  return text;
}

}  // namespace talus::input
