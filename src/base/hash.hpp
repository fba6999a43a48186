// SPDX-License-Identifier: MIT
#pragma once
// Hashes that name an input or a state.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace talus {

/// FNV-1a hash of a text, as 16 hexadecimal digits.
std::string hash_text(const std::string& text);

/// First state of mix_word().
inline constexpr std::uint64_t first_mix = 0xcbf29ce484222325ull;

/// FNV-1a (http://www.isthe.com/chongo/tech/comp/fnv) over words of eight bytes, each folded after its product so that
/// high bits reach low ones. It finds damage, not malice.
inline std::uint64_t mix_word(std::uint64_t state, std::uint64_t word) {
  state = (state ^ word) * 0x100000001b3ull;
  return state ^ (state >> 29);
}

/// Hash of a long content by mix_word(), which may come in pieces of any length.
class ContentHash {
 public:
  void add(std::span<const std::byte> bytes);
  /// Hash of all bytes so far.
  std::uint64_t value() const;

 private:
  std::uint64_t state_ = first_mix, size_ = 0, word_ = 0;  ///< the last word may be incomplete
};

}  // namespace talus
