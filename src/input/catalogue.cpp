// SPDX-License-Identifier: MIT
#include "input/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string_view>

#include "input/case/case.hpp"
#include "input/language/codec_types.hpp"
#include "input/read.hpp"

namespace talus::input {

namespace {

constexpr std::string_view within_name = ".NAME.";  ///< in the names of blocks within a named block

/// The visitor that collects the declarations; defaults are the members of default-constructed structs.
class Collector : public Visitor {
 public:
  explicit Collector(BlockEntry& block) : block_(block) {}

 protected:
  void visit_key(const std::string& name, Member member, const Spec& spec, const char* meaning) override {
    const KeyType& type = member.type;
    KeyEntry entry{name, spec, type.name(type, spec), meaning, "", {}, JsonTree(type.schema(type, spec))};
    const bool must_be_given = spec.may_be_required();
    const nlohmann::json value = type.encode(type, member.at, spec);
    if (!must_be_given && !value.is_null()) entry.default_text = write_toml(value);
    if (type.words.list != nullptr)
      for (const WordTable::Word& word : type.words.list()) entry.words.emplace_back(word.word, word.meaning);
    block_.keys.push_back(std::move(entry));
  }

  void visit_table(const std::string& name, const Blocks& block, const char* meaning) override {
    collect(add(BlockKind::table, name, "", 1, meaning), block, block.at);
  }
  void visit_optional_table(const std::string& name, const Blocks& block, const char* meaning) override {
    collect(add(BlockKind::table, name, "", 0, meaning), block, block.make().get());
  }
  void visit_tables(const std::string& name, const Blocks& blocks, int samples, const char* meaning) override {
    collect(add(BlockKind::list, name, "", samples, meaning), blocks, blocks.make().get());
  }
  void visit_named(const std::string& name, const Blocks& blocks, const char* sample, int samples,
                   const char* meaning) override {
    collect(add(BlockKind::named, name, sample, samples, meaning), blocks, blocks.make().get());
  }
  void visit_entries(const std::string& name, const Entries& values, const char* sample, int samples, const Spec& spec,
                     const char* meaning) override {
    BlockEntry entry = add(BlockKind::entries, name, sample, samples, meaning);
    Collector(entry).visit_key("NAME", {values.make().get(), values.type}, spec, meaning);
    block_.blocks.push_back(std::move(entry));
  }

 private:
  BlockEntry add(BlockKind kind, const std::string& name, const char* sample, int samples, const char* meaning) const {
    const std::string within = block_.kind == BlockKind::named ? block_.name + ".NAME" : block_.name;
    // Blocks within a named block inherit the sample name.
    const bool goes_on = block_.name.find(".NAME") != std::string::npos || block_.kind == BlockKind::named;
    return {kind, name, within.empty() ? name : within + "." + name, goes_on ? block_.sample : sample, samples, meaning,
            {},   {}};
  }

  void collect(BlockEntry entry, const Blocks& blocks, void* block) {
    Collector inner(entry);
    blocks.describe(inner, block);
    block_.blocks.push_back(std::move(entry));
  }

  BlockEntry& block_;
};

/// Adds a phrase for each key, block and choice called `word` of `block` and the blocks within it.
void gather_owners(const BlockEntry& block, const std::string& word, std::vector<std::string>& phrases) {
  const std::string header = block.name.empty() ? "the top of the file" : block.write_header();
  for (const KeyEntry& key : block.keys) {
    if (key.name == word && block.kind != BlockKind::entries) phrases.push_back("it is a key of " + header);
    for (const auto& choice : key.words)
      if (choice.first == word) phrases.push_back(fmt::format("it belongs to '{}' in {}", key.name, header));
  }
  for (const BlockEntry& inner : block.blocks) {
    if (inner.key == word && !block.name.empty()) phrases.push_back("write " + inner.write_header());
    gather_owners(inner, word, phrases);
  }
}

}  // namespace

bool KeyEntry::is_whole_number() const {
  return type == Codec<int>::name(spec);
}

const std::string& KeyEntry::get_example(std::size_t i) const {
  return spec.examples.empty() ? default_text : spec.examples[std::min(i, spec.examples.size() - 1)];
}

std::string BlockEntry::write_header(const std::string& chosen_name) const {
  if (const auto at = name.find(within_name); at != std::string::npos) {
    std::string chosen = name;
    return "[" + chosen.replace(at + 1, within_name.size() - 2, chosen_name) + "]";
  }
  if (kind == BlockKind::list) return "[[" + name + "]]";
  if (kind == BlockKind::named) return "[" + name + "." + chosen_name + "]";
  return "[" + name + "]";
}

std::optional<KeyEntry> find_key_entry(const std::string& path) {
  const std::vector<std::string> steps = split_path(path);
  const BlockEntry root = collect_catalogue();
  const BlockEntry* block = &root;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_last = i + 1 == steps.size();
    if (is_last)
      for (const KeyEntry& key : block->keys)
        if (key.name == steps[i] || block->kind == BlockKind::entries) return key;
    const auto inner = std::find_if(block->blocks.begin(), block->blocks.end(),
                                    [&](const BlockEntry& b) { return b.key == steps[i]; });
    if (inner == block->blocks.end()) return std::nullopt;
    block = &*inner;
    if (block->kind == BlockKind::list || block->kind == BlockKind::named) ++i;
  }
  return std::nullopt;
}

std::string describe_owners(const std::string& word) {
  std::vector<std::string> phrases;
  gather_owners(collect_catalogue(), word, phrases);
  if (phrases.empty() || phrases.size() > 2) return "";
  return phrases.size() == 1 ? phrases[0] : phrases[0] + ", or " + phrases[1];
}

BlockEntry collect_catalogue() {
  BlockEntry root;
  Case data;
  Collector visitor(root);
  describe(visitor, data);
  return root;
}

// `talus manual`: the keys of each block in a table, and an example of each block.

namespace {

/// Escapes "|", which ends the cell of a table.
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
      "`cohesion = 2` and `cohesion = \"2 kPa\"` are the same, and so is `cohesion = \"0.002 MPa\"`. Infinite values "
      "(`inf`) are refused except where this page says otherwise.\n"
      "Numbers outside the usual range, where a key has one, are allowed with a warning; `unusual` silences it.\n"
      "Keys that are not listed here are errors. `--set key=value` changes any key from the command line: `--set "
      "materials.sand.cohesion=5`,\n`--set stage.gravity.duration=\"3 s\"`, `--set boundary.0.fix=full` (entries of "
      "lists by their name, their side, or their number from 0).\n";
  return head + write_section(collect_catalogue());
}

// `talus schema`: JSON Schema of case files for completion and validation in editors.

namespace {

using nlohmann::json;

std::string write_description(const KeyEntry& key) {
  std::string text = key.meaning;
  for (const auto& [word, meaning] : key.words) text += fmt::format(" {}: {}.", word, meaning);
  if (!key.spec.unit.empty()) text += " Unit of plain numbers: " + key.spec.unit + ".";
  if (key.spec.usual_range) text += " Usually " + key.spec.write_usual_range() + ".";
  if (key.spec.condition) text += " Only where " + write_condition(*key.spec.condition) + ".";
  return text;
}

json write_key_schema(const KeyEntry& key) {
  json schema = key.schema.get();
  schema["description"] = write_description(key);
  if (!key.default_text.empty()) {
    // Defaults are TOML texts of numbers, words and lists, which are all valid JSON.
    const json value = json::parse(key.default_text, nullptr, false);
    if (!value.is_discarded()) schema["default"] = value;
  }
  return schema;
}

json write_block_schema(const BlockEntry& block);

/// Writes a condition such as 'if fix = "plane", then normal is required' as JSON Schema.
json write_requirement(const KeyEntry& key) {
  const Condition& condition = *key.spec.condition;
  const json then = {{"required", json::array({key.name})}};
  if (condition.is_absence())
    return {{"if", {{"not", {{"required", json::array({condition.any.front().key})}}}}}, {"then", then}};
  json cases = json::array();
  for (const Alternative& a : condition.any)
    cases.push_back({{"properties", {{a.key, {{"const", json::parse(a.value)}}}}}, {"required", json::array({a.key})}});
  return {{"if", cases.size() == 1 ? cases.front() : json{{"anyOf", cases}}}, {"then", then}};
}

/// Writes the object of keys and inner blocks; additional keys are rejected, as by the reader.
json write_object(const BlockEntry& block) {
  json object = {{"type", "object"}, {"additionalProperties", false}, {"properties", json::object()}};
  json required = json::array(), all_of = json::array();
  for (const KeyEntry& key : block.keys) {
    object["properties"][key.name] = write_key_schema(key);
    // Requirements that depend on the methods or on another table cannot be expressed here; the reader checks them.
    const bool has_waivers = !key.spec.methods.empty() || key.spec.instead;
    if (key.spec.is_required && !has_waivers) required.push_back(key.name);
    if (const auto& condition = key.spec.condition;
        condition && condition->required && !has_waivers && condition->any.front().key.find('.') == std::string::npos)
      all_of.push_back(write_requirement(key));
  }
  for (const BlockEntry& inner : block.blocks) object["properties"][inner.key] = write_block_schema(inner);
  if (!required.empty()) object["required"] = required;
  if (!all_of.empty()) object["allOf"] = all_of;
  return object;
}

json write_block_schema(const BlockEntry& block) {
  json schema;
  switch (block.kind) {
    case BlockKind::table:
      schema = write_object(block);
      break;
    case BlockKind::list:
      schema = {{"type", "array"}, {"items", write_object(block)}};
      break;
    case BlockKind::named:
      schema = {{"type", "object"}, {"additionalProperties", write_object(block)}};
      break;
    case BlockKind::entries:
      schema = {{"type", "object"}, {"additionalProperties", write_key_schema(block.keys.front())}};
      break;
  }
  schema["description"] = block.meaning;
  return schema;
}

}  // namespace

json write_schema() {
  json schema = write_object(collect_catalogue());
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "Talus case file";
  schema["required"] = json::array({"materials", "regions"});
  // Stages are a feature of MPM.
  const json no_points = {{"not", {{"contains", {{"const", "mpm"}}}}}};
  const json asks = {{"required", {"methods"}}, {"properties", {{"methods", no_points}}}};
  schema["if"] = {{"required", {"analysis"}}, {"properties", {{"analysis", asks}}}};
  schema["else"] = {{"required", {"stage"}}};
  return schema;
}

// `talus template`: a case file that can be calculated unchanged and contains every key with its default. A line "#key
// = value" is a default, which can be uncommented without effect; "# ..." is prose.

namespace {

constexpr std::size_t line_width = 110;

/// Writes a paragraph as lines that begin with "# ".
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

/// Returns the value of `key` in sample `i` of the template; empty if it is not set.
std::string find_value(const BlockEntry& block, const std::string& key, std::size_t i);

/// Returns true if the condition of a key holds in sample `i` of its block. The template has no external mesh file.
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
  // For an empty list or text as the default, an example is more useful.
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
