// SPDX-License-Identifier: MIT
#pragma once
// Hashes that name an input or a state.

#include <string>

namespace talus {

/// FNV-1a hash of a text, as 16 hexadecimal digits.
std::string hash_text(const std::string& text);

}  // namespace talus
