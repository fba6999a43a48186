// SPDX-License-Identifier: MIT
#pragma once
// Encodings of text files, and what of a text may reach a terminal or a file of another format.

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

/// True for UTF-16: the text begins with a byte order mark, or with a zero byte beside its first character.
bool is_utf16(std::string_view text);

/// The first byte that is not UTF-8 (RFC 3629): its place from the start of the text. Nothing where all are.
std::optional<std::size_t> find_wrong_utf8(std::string_view text);

/// The letters A to Z in lower case, whatever the locale is: a Turkish one has no i for I.
std::string to_lower(std::string_view text);

/// `text` with "\x1b" for each control character, "\u202e" for each that changes the direction of the text or that XML
/// does not allow, and "\xff" for each byte that is no UTF-8. Line breaks stay with `keeps_lines`.
std::string make_printable(std::string_view text, bool keeps_lines = false);

/// Prints lines that may hold names of a case or of a file.
void print(std::FILE* stream, std::string_view text);

// Which of the known words a mistyped one was meant to be.

/// The smallest number of letters to insert, delete, replace or swap with their neighbour to turn `a` into `b`
/// (optimal string alignment distance); upper and lower case count as half different, rounded up over the word.
int measure_edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, or an empty string when none is near: more than a third of its letters differ.
std::string find_nearest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace talus
