// SPDX-License-Identifier: MIT
#pragma once
// Texts to TOML tables, with a sentence on what engineers write instead of TOML.

#include <toml++/toml.h>

#include <string>

namespace talus::input {

/// The table of a case file. Throws InputError with one diagnostic for a text that is not UTF-8 or not TOML. `name` is
/// the file in its places.
toml::table parse_toml(const std::string& text, const std::string& name);

}  // namespace talus::input
