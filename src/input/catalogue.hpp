// SPDX-License-Identifier: MIT
#pragma once
// All declared keys as data: the source of the manual, the template and the JSON Schema.

#include <string>
#include <utility>
#include <vector>

#include "base/json_tree.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

struct KeyEntry {
  std::string name;
  Spec spec;
  std::string type;  ///< what to write: "number [kPa]", "word", ...
  std::string meaning;
  std::string default_text;                                ///< TOML text; empty when there is no default
  std::vector<std::pair<std::string, std::string>> words;  ///< of a choice: word and meaning
  JsonTree schema;                                         ///< JSON Schema of what may be written

  /// An example of a value: that of sample `i` of a list, or the default.
  const std::string& get_example(std::size_t i = 0) const;
};

enum class BlockKind {
  table,    ///< [name]
  list,     ///< [[name]]
  named,    ///< [name.NAME], NAME being of the user's choice
  entries,  ///< [name] with keys of the user's choice; keys[0] stands for all of them
};

struct BlockEntry {
  BlockKind kind = BlockKind::table;
  std::string key;     ///< last part of the name
  std::string name;    ///< whole name: materials, materials.NAME.water
  std::string sample;  ///< a name of the user's choice, for examples
  int samples = 1;     ///< how many entries the template shows; 0: as a comment only
  std::string meaning;
  std::vector<KeyEntry> keys;
  std::vector<BlockEntry> blocks;

  /// [mesh], [[stage]], [materials.NAME], [materials.NAME.water]; with `chosen_name` in the place of NAME.
  std::string write_header(const std::string& chosen_name = "NAME") const;
};

/// The whole case file: a block without name.
BlockEntry collect_catalogue();

/// Names the places of a key, a block or a choice of this name in a case file: "it is a key of [lem]", "it belongs to
/// 'methods' in [lem]"; empty where none has it, or more than two do.
std::string describe_owners(const std::string& word);

}  // namespace talus::input
