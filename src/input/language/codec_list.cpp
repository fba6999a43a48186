// SPDX-License-Identifier: MIT
#include "input/language/codec_list.hpp"

#include <fmt/format.h>

namespace talus::input {
namespace {

using nlohmann::json;

const toml::array* find_list(const Decoding& in, const toml::node& node, const std::string& path,
                             const std::string& wanted) {
  const toml::array* list = node.as_array();
  if (list == nullptr) in.fail_type(node, path, wanted);
  return list;
}

}  // namespace

bool decode_words(const Decoding& in, const toml::node& node, const std::string& path,
                  const std::vector<std::string>& words, std::vector<std::size_t>& out) {
  const toml::array* list = find_list(in, node, path, "a list of words");
  if (list == nullptr) return false;
  bool is_good = true;
  out.assign(list->size(), 0);
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string item_path = fmt::format("{}.{}", path, i);
    is_good = decode_word(in, *list->get(i), item_path, words, out[i]) && is_good;
    in.record(*list->get(i), item_path);
  }
  return is_good;
}

bool Codec<std::vector<std::string>>::decode(const Decoding& in, const toml::node& node, const std::string& path,
                                             std::vector<std::string>& out) {
  const toml::array* list = find_list(in, node, path, "a list of texts");
  if (list == nullptr) return false;
  out.clear();
  for (std::size_t i = 0; i < list->size(); ++i) {
    const toml::node& item = *list->get(i);
    const std::string item_path = fmt::format("{}.{}", path, i);
    const auto* text = item.as_string();
    if (text == nullptr) return in.fail_type(item, item_path, "a list of texts in quotation marks");
    in.record(item, item_path);
    out.push_back(text->get());
  }
  return true;
}

bool Codec<std::array<double, 2>>::decode(const Decoding& in, const toml::node& node, const std::string& path,
                                          std::array<double, 2>& out) {
  std::vector<double> xy;
  if (!decode_numbers(in, node, path, 2, 2, "a point [x, y]", xy)) return false;
  out = {xy[0], xy[1]};
  return true;
}

json Codec<std::array<double, 2>>::encode(const std::array<double, 2>& value, const Spec& spec) {
  return json::array({encode_number(value[0], spec), encode_number(value[1], spec)});
}

std::string Codec<std::array<double, 2>>::name(const Spec& spec) {
  return spec.unit.empty() ? "[x, y]" : fmt::format("[x, y] [{}]", spec.unit);
}

bool Codec<std::uint64_t>::decode(const Decoding& in, const toml::node& node, const std::string& path,
                                  std::uint64_t& out) {
  const auto* number = node.as_integer();
  if (number == nullptr) return in.fail_type(node, path, "a whole number");
  if (number->get() < 0)
    return in.fail(node, path, fmt::format("'{}' is {}; it must be at least 0", in.key, number->get()));
  out = static_cast<std::uint64_t>(number->get());
  return true;
}

bool Codec<TomlText>::decode(const Decoding& in, const toml::node& node, const std::string& path, TomlText& out) {
  if (!node.is_number() && !node.is_string())
    return in.fail_type(node, path, "a number, or a text with a unit such as \"2 kPa\"");
  in.record(node, path);
  out.text = write_toml(node);
  return true;
}

json Codec<TomlText>::encode(const TomlText& value, const Spec&) {
  if (value.text.empty()) return nullptr;
  json parsed = json::parse(value.text, nullptr, false);
  return parsed.is_discarded() ? json(value.text) : parsed;
}

}  // namespace talus::input
