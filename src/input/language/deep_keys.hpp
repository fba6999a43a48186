// SPDX-License-Identifier: MIT
#pragma once
// Dotted keys that the parser of TOML would not survive.

#include <optional>
#include <string_view>

namespace talus::input {

/// A place in a text; line and column count from 1.
struct TextPlace {
  int line = 1, column = 1;
};

/// The largest number of dots in a key that is let through; no key of a case has more than six parts.
inline constexpr int most_dots = 100;

/// Where a key with more than `most_dots` dots begins to have them. The parser follows the parts of a key one within
/// the other, and thousands of them would end its stack. Strings and comments may hold as many dots as they like.
std::optional<TextPlace> find_deep_key(std::string_view toml);

}  // namespace talus::input
