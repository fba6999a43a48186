// SPDX-License-Identifier: MIT
#include "input/list_files.hpp"

#include <algorithm>

#include "input/language/apply_overrides.hpp"

namespace talus::input {
namespace {

/// The keys that name a file: `file` of a mesh, a series or a measured curve, `library` of a soil, `result` of
/// [initial].
void gather_files(const toml::node& node, std::vector<std::string>& names) {
  if (const toml::array* list = node.as_array())
    for (const toml::node& entry : *list) gather_files(entry, names);
  const toml::table* table = node.as_table();
  if (table == nullptr) return;
  for (const auto& [key, value] : *table) {
    const std::string_view name = key.str();
    if (name == "study" || name == "title") continue;
    const std::optional<std::string> text = value.value<std::string>();
    if (!text || text->empty() || (name != "file" && name != "library" && name != "result")) {
      gather_files(value, names);
      continue;
    }
    if (std::find(names.begin(), names.end(), *text) == names.end()) names.push_back(*text);
  }
}

}  // namespace

std::vector<std::string> list_files(const std::string& text, const std::vector<Override>& overrides) {
  toml::table root = toml::parse(text);
  Places places("");
  Findings findings(places);
  apply_overrides(root, overrides, findings);
  std::vector<std::string> names;
  gather_files(root, names);
  return names;
}

}  // namespace talus::input
