// SPDX-License-Identifier: MIT
#pragma once
// All declared keys as data: the source of the manual, the template and the JSON Schema.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/json_tree.hpp"
#include "input/language/spec.hpp"

namespace talus::input {

struct KeyEntry {
  std::string name;
  Spec spec;
  std::string type;  ///< form of the value: "number [kPa]", "word", ...
  std::string meaning;
  std::string default_text;                                ///< TOML text; empty without default
  std::vector<std::pair<std::string, std::string>> words;  ///< for a choice: word and meaning
  JsonTree schema;                                         ///< JSON Schema of the value

  bool is_whole_number() const;
  /// Returns an example of a value: that of sample `i` of a list, or the default.
  const std::string& get_example(std::size_t i = 0) const;
};

enum class BlockKind {
  table,    ///< [name]
  list,     ///< [[name]]
  named,    ///< [name.NAME] with a user-defined NAME
  entries,  ///< [name] with user-defined keys; keys[0] describes all of them
};

struct BlockEntry {
  BlockKind kind = BlockKind::table;
  std::string key;     ///< last part of the name
  std::string name;    ///< full name: materials, materials.NAME.water
  std::string sample;  ///< an example of a user-defined name
  int samples = 1;     ///< number of entries in the template; 0: as a comment only
  std::string meaning;
  std::vector<KeyEntry> keys;
  std::vector<BlockEntry> blocks;

  /// Writes [mesh], [[stage]], [materials.NAME], [materials.NAME.water]; with `chosen_name` instead of NAME.
  std::string write_header(const std::string& chosen_name = "NAME") const;
};

/// Returns the whole case file as a block without name.
BlockEntry collect_catalogue();

/// Returns the declaration of the key at a dotted path as for --set, with names or numbers of entries; std::nullopt if
/// there is none.
std::optional<KeyEntry> find_key_entry(const std::string& path);

/// Describes the places of a key, a block or a choice of this name in a case file: "it is a key of [lem]", "it belongs
/// to 'methods' in [lem]"; empty if there are none or more than two.
std::string describe_owners(const std::string& word);

}  // namespace talus::input
