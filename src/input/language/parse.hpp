// SPDX-License-Identifier: MIT
#pragma once
// Parsing of case files and of --set, with messages for common mistakes in TOML.

#include <toml++/toml.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/language/findings.hpp"

namespace talus::input {

/// Returns the table of a case file. Throws InputError with one diagnostic if the text is not UTF-8 or not TOML. `name`
/// is the file name in places.
toml::table parse_toml(const std::string& text, const std::string& name);

// Protection against dotted keys that overflow the stack of the TOML parser.

/// A place in a text; line and column count from 1.
struct TextPlace {
  int line = 1, column = 1;
};

/// Largest number of dots in a key that is accepted; no key of a case has more than six parts.
inline constexpr int most_dots = 100;

/// Returns the place at which a key exceeds `most_dots` dots. The parser is recursive in the parts of a key, and
/// thousands of them overflow its stack. Strings and comments are not limited.
std::optional<TextPlace> find_deep_key(std::string_view toml);

// --set key=value: changes of a case file on the command line.

/// One --set. `key` is a dotted path; an entry of a list of tables is identified by its `name` or `on`, or by its index
/// from 0 ("stage.gravity.duration", "boundary.0.fix"). `value` is TOML text; a bare word is a text.
struct Override {
  std::string key;
  std::string value;
};

/// Returns the entry of a list in an echo that a step of such a path identifies; nullptr if there is none.
const nlohmann::json* find_entry(const nlohmann::json& list, const std::string& step);

/// Returns the steps of a dotted path.
std::vector<std::string> split_path(const std::string& path);

/// Splits "key=value". Throws Error (wrong_input) if there is no "=" or no key.
Override parse_override(const std::string& text);

// Application of overrides to the table of a case file.

/// Applies the overrides to the table; `findings` receives their places and the faults of impossible ones.
void apply_overrides(toml::table& root, const std::vector<Override>& overrides, Findings& findings);

}  // namespace talus::input
