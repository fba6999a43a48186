// SPDX-License-Identifier: MIT
#include "base/hash.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace talus {

std::string hash_text(const std::string& text) {
  std::uint64_t h = 14695981039346656037ull;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return fmt::format("{:016x}", h);
}

}  // namespace talus
