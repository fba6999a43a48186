// SPDX-License-Identifier: MIT
// `talus manual`: every key in a table of its block, and an example of each block.

#include <fmt/format.h>

#include "input/catalogue.hpp"
#include "input/read.hpp"

namespace talus::input {
namespace {

/// "|" would end the cell of a table.
std::string write_cell(const std::string& text) {
  std::string cell;
  for (const char c : text) cell += c == '|' ? std::string("\\|") : std::string(1, c);
  return cell;
}

std::string write_default(const KeyEntry& key) {
  if (const auto& condition = key.spec.condition; condition && condition->required)
    return fmt::format("required where `{}`{}", write_condition(*condition), write_waivers(key.spec));
  if (key.spec.is_required) return "required" + write_waivers(key.spec);
  std::string text = key.default_text.empty() ? "none" : fmt::format("`{}`", key.default_text);
  if (const auto& condition = key.spec.condition) text += fmt::format("; only where `{}`", write_condition(*condition));
  return text;
}

std::string write_type(const KeyEntry& key) {
  if (key.words.empty()) return key.type;
  const bool is_list = key.type != "word";
  std::string text;
  for (const auto& [word, meaning] : key.words) text += fmt::format("{}`\"{}\"`", text.empty() ? "" : ", ", word);
  return is_list ? key.type + ": " + text : text;
}

std::string write_meaning(const KeyEntry& key) {
  std::string text = key.meaning;
  for (const auto& [word, meaning] : key.words) text += fmt::format("<br>`{}`: {}", word, meaning);
  return text;
}

std::string write_ranges(const Spec& spec) {
  const std::string range = spec.write_range(), usual = spec.write_usual_range();
  return usual.empty() ? range : fmt::format("{}{}usually {}", range, range.empty() ? "" : "; ", usual);
}

std::string write_keys(const BlockEntry& block) {
  std::string text = "| Key | Value | Range | Default | Meaning |\n|---|---|---|---|---|\n";
  for (const KeyEntry& key : block.keys)
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, write_cell(write_type(key)), write_ranges(key.spec),
                        write_cell(write_default(key)), write_cell(write_meaning(key)));
  return text;
}

std::string write_example(const BlockEntry& block) {
  std::string text = "\nExample of each line:\n\n```toml\n";
  if (!block.name.empty()) text += block.write_header(block.sample) + "\n";
  for (const KeyEntry& key : block.keys)
    text += fmt::format("{} = {}\n", block.kind == BlockKind::entries ? block.sample : key.name, key.get_example());
  return text + "```\n";
}

std::string write_section(const BlockEntry& block) {
  std::string text;
  if (!block.name.empty()) text = fmt::format("\n## `{}`\n\n{}\n", block.write_header(), block.meaning);
  if (!block.keys.empty()) text += "\n" + write_keys(block) + write_example(block);
  for (const BlockEntry& inner : block.blocks) text += write_section(inner);
  return text;
}

}  // namespace

std::string write_manual() {
  const std::string head =
      "# The case file\n\n"
      "A case is one TOML file. This page is written by `talus manual` from the declarations that also read the "
      "file.\n\n"
      "A quantity is a number in the unit that stands in brackets, or a text with any unit of the same dimension:\n"
      "`cohesion = 2` and `cohesion = \"2 kPa\"` are the same, and so is `cohesion = \"0.002 MPa\"`. "
      "Infinite values (`inf`) are refused except where this page says otherwise.\n"
      "Numbers outside the usual range, where a key has one, are allowed with a warning; `unusual` silences it.\n"
      "Keys that are not listed here are errors. `--set key=value` changes any key from the command line: "
      "`--set materials.sand.cohesion=5`,\n`--set stage.gravity.duration=\"3 s\"`, `--set boundary.0.fix=full` "
      "(entries of lists by their name, their side, or their number from 0).\n";
  return head + write_section(collect_catalogue());
}

}  // namespace talus::input
