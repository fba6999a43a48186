// SPDX-License-Identifier: MIT
#pragma once
// Encodings of text files.

#include <cstddef>
#include <optional>
#include <string_view>

namespace talus {

/// True for UTF-16: the text begins with a byte order mark, or with a zero byte beside its first character.
bool is_utf16(std::string_view text);

/// The first byte that is not UTF-8 (RFC 3629): its place from the start of the text. Nothing where all are.
std::optional<std::size_t> find_wrong_utf8(std::string_view text);

}  // namespace talus
