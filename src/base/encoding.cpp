// SPDX-License-Identifier: MIT
#include "base/encoding.hpp"

namespace talus {
namespace {

/// Smallest character of 2, 3 and 4 bytes: a smaller one has a shorter form.
constexpr unsigned smallest[] = {0, 0, 0x80, 0x800, 0x10000};

/// Bytes of the character that begins with `first`; 0: none does.
std::size_t count_bytes(unsigned char first) {
  if (first < 0x80) return 1;
  if ((first & 0xE0U) == 0xC0) return 2;
  if ((first & 0xF0U) == 0xE0) return 3;
  return (first & 0xF8U) == 0xF0 ? 4 : 0;
}

bool is_character(std::string_view bytes) {
  if (bytes.size() == 1) return true;
  unsigned code = static_cast<unsigned char>(bytes[0]) & (0xFFU >> (bytes.size() + 1));
  for (const char c : bytes.substr(1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) != 0x80) return false;
    code = (code << 6U) | (byte & 0x3FU);
  }
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code >= smallest[bytes.size()] && code <= 0x10FFFF && !is_surrogate;
}

}  // namespace

bool is_utf16(std::string_view text) {
  if (text.size() < 2) return false;
  const std::string_view mark = text.substr(0, 2);
  return mark == "\xFF\xFE" || mark == "\xFE\xFF" || (mark[0] == '\0') != (mark[1] == '\0');
}

std::optional<std::size_t> find_wrong_utf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t count = count_bytes(static_cast<unsigned char>(text[at]));
    if (count == 0 || at + count > text.size() || !is_character(text.substr(at, count))) return at;
    at += count;
  }
  return std::nullopt;
}

}  // namespace talus
