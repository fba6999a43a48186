// SPDX-License-Identifier: MIT
#pragma once
// Texts to TOML tables, with a sentence on what engineers write instead of TOML.

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/language/findings.hpp"

namespace talus::input {

/// The table of a case file. Throws InputError with one diagnostic for a text that is not UTF-8 or not TOML. `name` is
/// the file in its places.
toml::table parse_toml(const std::string& text, const std::string& name);

// Dotted keys that the parser of TOML would not survive.

/// A place in a text; line and column count from 1.
struct TextPlace {
  int line = 1, column = 1;
};

/// The largest number of dots in a key that is let through; no key of a case has more than six parts.
inline constexpr int most_dots = 100;

/// Where a key with more than `most_dots` dots begins to have them. The parser follows the parts of a key one within
/// the other, and thousands of them would end its stack. Strings and comments may hold as many dots as they like.
std::optional<TextPlace> find_deep_key(std::string_view toml);

// --set key=value: changes of a case file that are made on the command line.

/// One --set. `key` is a dotted path; an entry of a list of tables is named by its `name` or `on`, or by its number
/// from 0 ("stage.gravity.duration", "boundary.0.fix"). `value` is TOML text; a bare word is a text.
struct Override {
  std::string key;
  std::string value;
};

/// The steps of a dotted path.
std::vector<std::string> split_path(const std::string& path);

/// Splits "key=value". Throws Error (wrong_input) when there is no "=" or no key.
Override parse_override(const std::string& text);

// Overrides on their way into the table of a case file.

/// Writes the overrides into the table, and tells `findings` where they went and which of them are impossible.
void apply_overrides(toml::table& root, const std::vector<Override>& overrides, Findings& findings);

}  // namespace talus::input
