// SPDX-License-Identifier: MIT
#pragma once
// --set key=value: changes of a case file that are made on the command line.

#include <string>
#include <vector>

namespace talus::input {

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

}  // namespace talus::input
