// SPDX-License-Identifier: MIT
#include "input/language/deep_keys.hpp"

#include <algorithm>

namespace talus::input {
namespace {

/// Where the string that begins at `at` ends; a string of one line ends with its line at the latest.
std::size_t skip_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view three = text.substr(at, 3);
  const bool is_long = three.size() == 3 && three[1] == quote && three[2] == quote;
  const std::string_view end = is_long ? three : text.substr(at, 1);
  at += end.size();
  while (at < text.size() && text.substr(at, end.size()) != end) {
    if (!is_long && text[at] == '\n') return at;
    at += quote == '"' && text[at] == '\\' ? 2 : 1;
  }
  return std::min(at + end.size(), text.size());
}

TextPlace find_place(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const std::size_t last = before.rfind('\n');
  return {1 + static_cast<int>(std::ranges::count(before, '\n')),
          static_cast<int>(last == std::string_view::npos ? at + 1 : at - last)};
}

}  // namespace

std::optional<TextPlace> find_deep_key(std::string_view text) {
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '"' || c == '\'') {
      i = skip_string(text, i);
      continue;
    }
    if (c == '.' && ++dots > most_dots) return find_place(text, i);
    if (std::string_view("=[]{},\n").find(c) != std::string_view::npos) dots = 0;
    ++i;
  }
  return std::nullopt;
}

}  // namespace talus::input
