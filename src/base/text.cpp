// SPDX-License-Identifier: MIT
#include "base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace talus {

namespace {

/// Smallest code point of 2, 3 and 4 bytes; smaller ones are overlong encodings.
constexpr unsigned smallest[] = {0, 0, 0x80, 0x800, 0x10000};

constexpr unsigned no_character = 0xFFFFFFFF;

/// Returns the length in bytes of a character whose first byte is `first`; 0 if it is not a first byte.
std::size_t count_bytes(unsigned char first) {
  if (first < 0x80) return 1;
  if ((first & 0xE0U) == 0xC0) return 2;
  if ((first & 0xF0U) == 0xE0) return 3;
  return (first & 0xF8U) == 0xF0 ? 4 : 0;
}

unsigned decode_character(std::string_view bytes) {
  if (bytes.size() == 1) return static_cast<unsigned char>(bytes[0]);
  unsigned code = static_cast<unsigned char>(bytes[0]) & (0xFFU >> (bytes.size() + 1));
  for (const char c : bytes.substr(1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) != 0x80) return no_character;
    code = (code << 6U) | (byte & 0x3FU);
  }
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code >= smallest[bytes.size()] && code <= 0x10FFFF && !is_surrogate ? code : no_character;
}

struct CodeRange {
  unsigned first, last;
};
/// Control characters, directional marks and embeddings, line and paragraph separators, and characters that XML
/// excludes.
constexpr CodeRange not_printable[] = {{0x00, 0x1F},     {0x7F, 0x9F},     {0x200E, 0x200F},
                                       {0x2028, 0x202E}, {0x2066, 0x2069}, {0xFFFE, 0xFFFF}};

/// Returns the first character of `text` and its length; no_character and one byte if it is not valid.
std::pair<unsigned, std::size_t> take_character(std::string_view text) {
  const std::size_t count = count_bytes(static_cast<unsigned char>(text[0]));
  const unsigned code = count == 0 || count > text.size() ? no_character : decode_character(text.substr(0, count));
  return {code, code == no_character ? 1 : count};
}

}  // namespace

bool is_utf16(std::string_view text) {
  if (text.size() < 2) return false;
  const std::string_view mark = text.substr(0, 2);
  return mark == "\xFF\xFE" || mark == "\xFE\xFF" || (mark[0] == '\0') != (mark[1] == '\0');
}

std::optional<std::size_t> find_wrong_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, count] = take_character(text.substr(at));
    if (code == no_character) return at;
    at += count;
  }
  return std::nullopt;
}

std::string to_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::string make_printable(std::string_view text, bool keeps_lines) {
  std::string printable;
  while (!text.empty()) {
    const auto [code, count] = take_character(text);
    const bool is_line = code == '\n' && keeps_lines;
    const auto is_in = [code = code](const CodeRange& r) { return r.first <= code && code <= r.last; };
    if (code == no_character)
      printable += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    else if (!is_line && std::any_of(std::begin(not_printable), std::end(not_printable), is_in))
      printable += code < 0x80 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
    else
      printable += text.substr(0, count);
    text.remove_prefix(count);
  }
  return printable;
}

void print(std::FILE* stream, std::string_view text) {
  const std::string printable = make_printable(text, true);
  std::fwrite(printable.data(), 1, printable.size(), stream);
}

int measure_edit_distance(std::string_view a, std::string_view b) {
  const std::size_t n = a.size(), m = b.size();
  const std::string lower_a = to_lower(a), lower_b = to_lower(b);
  // Costs are in halves, so that a wrong case costs less than a wrong letter.
  std::vector<std::vector<int>> d(n + 1, std::vector<int>(m + 1));
  for (std::size_t i = 0; i <= n; ++i) d[i][0] = static_cast<int>(2 * i);
  for (std::size_t j = 0; j <= m; ++j) d[0][j] = static_cast<int>(2 * j);
  for (std::size_t i = 1; i <= n; ++i) {
    for (std::size_t j = 1; j <= m; ++j) {
      const int change = a[i - 1] == b[j - 1] ? 0 : lower_a[i - 1] == lower_b[j - 1] ? 1 : 2;
      d[i][j] = std::min({d[i - 1][j] + 2, d[i][j - 1] + 2, d[i - 1][j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 2);
    }
  }
  return (d[n][m] + 1) / 2;
}

std::string find_nearest(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  int least = std::max(1, static_cast<int>(word.size()) / 3) + 1;
  for (const std::string& candidate : candidates) {
    const int distance = measure_edit_distance(word, candidate);
    if (distance < least) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

std::string suggest(std::string_view word, const std::vector<std::string>& known) {
  const std::string near = find_nearest(word, known);
  if (!near.empty()) return fmt::format("did you mean '{}'?", near);
  return known.empty() ? "known: there are none" : fmt::format("known: {}", fmt::join(known, ", "));
}

}  // namespace talus
