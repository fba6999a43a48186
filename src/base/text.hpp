// SPDX-License-Identifier: MIT
#pragma once
// Encodings of text files, sanitised output to terminals and other formats, and suggestions for mistyped words.

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

/// Returns true for UTF-16: the text begins with a byte order mark, or its first character has a zero byte.
bool is_utf16(std::string_view text);

/// Returns the offset of the first byte that is not valid UTF-8 (RFC 3629); std::nullopt if there is none.
std::optional<std::size_t> find_wrong_utf8(std::string_view text);

/// Converts the letters A to Z to lower case, independent of the locale (a Turkish one maps I to a dotless i).
std::string to_lower(std::string_view text);

/// Returns `text` with escapes: "\x1b" for control characters, "\u202e" for characters that change the text direction
/// or that XML excludes, and "\xff" for bytes that are not valid UTF-8. `keeps_lines` keeps line breaks.
std::string make_printable(std::string_view text, bool keeps_lines = false);

/// Prints lines that may contain names from a case or a file, with make_printable().
void print(std::FILE* stream, std::string_view text);

// Suggestions for mistyped words.

/// Returns the optimal string alignment distance: the smallest number of insertions, deletions, replacements and swaps
/// of adjacent letters that turn `a` into `b`. A wrong case counts half, rounded up over the word.
int measure_edit_distance(std::string_view a, std::string_view b);

/// Returns the candidate nearest to `word`; empty if more than a third of the letters differ for all of them.
std::string find_nearest(std::string_view word, const std::vector<std::string>& candidates);

/// Returns "did you mean 'sand'?", or "known: clay, sand" if no known word is near.
std::string suggest(std::string_view word, const std::vector<std::string>& known);

}  // namespace talus
