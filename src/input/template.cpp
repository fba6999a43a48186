// SPDX-License-Identifier: MIT
// `talus template`: a case file that can be calculated as it is, in which every key stands with its default.
// A line "#key = value" is a default that can be uncommented without changing anything; "# ..." is prose.

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "input/catalogue.hpp"
#include "input/read.hpp"

namespace talus::input {
namespace {

constexpr std::size_t line_width = 110;

/// A paragraph as lines that begin with "# ".
std::string write_comment(const std::string& text) {
  std::istringstream words(text);
  std::string result, line = "#", word;
  while (words >> word) {
    if (line.size() + 1 + word.size() > line_width) {
      result += line + "\n";
      line = "#  ";
    }
    line += " " + word;
  }
  return result + line + "\n";
}

std::string write_note(const KeyEntry& key) {
  std::string text = key.meaning + " ";
  if (key.words.empty()) {
    const std::string range = key.spec.write_range();
    text += fmt::format("({}{})", key.type, range.empty() ? "" : ", " + range);
  } else {
    std::string list;
    for (const auto& [word, meaning] : key.words)
      list += fmt::format("{}\"{}\": {}", list.empty() ? "" : "; ", word, meaning);
    text += fmt::format("({})", list);
  }
  return write_comment(text);
}

/// What `key` of sample `i` is set to in the template; empty when it is not set.
std::string find_value(const BlockEntry& block, const std::string& key, std::size_t i);

/// Whether the condition of a key holds in sample `i` of its block. The template names no ready mesh file.
bool holds(const BlockEntry& block, const Condition& condition, std::size_t i) {
  return condition.is_absence() || std::any_of(condition.any.begin(), condition.any.end(), [&](const Alternative& a) {
           return (find_value(block, a.key, i) == a.value) != a.differs;
         });
}

bool is_set(const BlockEntry& block, const KeyEntry& key, std::size_t i) {
  if (key.spec.condition) return key.spec.condition->required && holds(block, *key.spec.condition, i);
  return key.spec.is_required;
}

std::string find_value(const BlockEntry& block, const std::string& key, std::size_t i) {
  for (const KeyEntry& entry : block.keys)
    if (entry.name == key) return is_set(block, entry, i) ? entry.get_example(i) : entry.default_text;
  return "";
}

std::string write_key(const BlockEntry& block, const KeyEntry& key, std::size_t i) {
  const std::string name = block.kind == BlockKind::entries ? block.sample : key.name;
  if (block.samples == 0) return fmt::format("#   {} = {}\n", name, key.get_example(i));
  if (is_set(block, key, i)) return fmt::format("{} = {}\n", name, key.get_example(i));
  if (i > 0) return "";
  if (key.spec.condition && !holds(block, *key.spec.condition, i))
    return write_comment(
        fmt::format("  only with {}: {} = {}", write_condition(*key.spec.condition), name, key.get_example(i)));
  // An empty list or text as a default says less than an example of what could stand there.
  const bool says_nothing = key.default_text.empty() || key.default_text == "\"\"" || key.default_text == "[]";
  std::string text = key.default_text.empty() ? "" : fmt::format("#{} = {}\n", name, key.default_text);
  if (says_nothing && !key.spec.examples.empty())
    text = write_comment(fmt::format("  for example: {} = {}", name, key.get_example(i))) + text;
  return text;
}

std::string write_block(const BlockEntry& block) {
  std::string text;
  if (!block.name.empty() && (!block.keys.empty() || block.samples == 0))
    text += "\n" + write_comment("---- " + block.meaning);
  const std::size_t samples = static_cast<std::size_t>(std::max(1, block.samples));
  for (std::size_t i = 0; i < samples && !block.keys.empty(); ++i) {
    const std::string header = block.write_header(block.sample);
    if (block.samples == 0)
      text += "#   " + header + "\n";
    else if (!block.name.empty())
      text += (i > 0 ? "\n" : "") + header + "\n";
    for (const KeyEntry& key : block.keys) {
      if (i == 0 && block.kind != BlockKind::entries) text += write_note(key);
      text += write_key(block, key, i);
    }
  }
  for (const BlockEntry& inner : block.blocks) text += write_block(inner);
  return text;
}

}  // namespace

std::string write_template() {
  const std::string head =
      "# A case of Talus: a dry, homogeneous slope. Keys without a default are set; \"#key = value\" shows a default.\n"
      "# Quantities are numbers in the unit in brackets, or texts with a unit such as \"45 MPa\".\n\n";
  return head + write_block(collect_catalogue());
}

}  // namespace talus::input
