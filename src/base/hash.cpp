// SPDX-License-Identifier: MIT
#include "base/hash.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace talus {

std::string hash_text(const std::string& text) {
  std::uint64_t h = 14695981039346656037ull;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return fmt::format("{:016x}", h);
}

void ContentHash::add(std::span<const std::byte> bytes) {
  constexpr std::size_t width = sizeof word_;
  const auto fill = [&](std::size_t count) {
    std::memcpy(reinterpret_cast<std::byte*>(&word_) + size_ % width, bytes.data(), count);
    size_ += count;
    bytes = bytes.subspan(count);
    if (size_ % width != 0) return;
    state_ = mix_word(state_, word_);
    word_ = 0;
  };
  if (size_ % width != 0) fill(std::min<std::size_t>(width - size_ % width, bytes.size()));
  for (; bytes.size() >= width; bytes = bytes.subspan(width), size_ += width) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), width);
    state_ = mix_word(state_, word);
  }
  if (!bytes.empty()) fill(bytes.size());
}

std::uint64_t ContentHash::value() const {
  return mix_word(size_ % sizeof word_ == 0 ? state_ : mix_word(state_, word_), size_);
}

}  // namespace talus
