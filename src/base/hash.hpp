// SPDX-License-Identifier: MIT
#pragma once
// FNV-1a hashes of inputs and states.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace talus {

/// Returns the FNV-1a hash of a text as 16 hexadecimal digits.
std::string hash_text(const std::string& text);

/// Initial state of mix_word().
inline constexpr std::uint64_t first_mix = 0xcbf29ce484222325ull;

/// FNV-1a (http://www.isthe.com/chongo/tech/comp/fnv) over words of eight bytes, each folded after its product to
/// propagate high bits to low ones. It detects damage, not manipulation.
inline std::uint64_t mix_word(std::uint64_t state, std::uint64_t word) {
  state = (state ^ word) * 0x100000001b3ull;
  return state ^ (state >> 29);
}

/// Hash by mix_word() of content that is added in pieces of any length.
class ContentHash {
 public:
  void add(std::span<const std::byte> bytes);
  /// Returns the hash of all bytes added so far.
  std::uint64_t value() const;

 private:
  std::uint64_t state_ = first_mix, size_ = 0, word_ = 0;  ///< the last word may be incomplete
};

}  // namespace talus
