// SPDX-License-Identifier: MIT
#include "study/random_stream.hpp"

namespace talus::study {
namespace {

constexpr std::uint64_t multiplier_0 = 0xD2511F53, multiplier_1 = 0xCD9E8D57;
constexpr std::uint32_t weyl_0 = 0x9E3779B9, weyl_1 = 0xBB67AE85;
constexpr int rounds = 10;

std::uint32_t take_low(std::uint64_t x) {
  return static_cast<std::uint32_t>(x & 0xFFFFFFFF);
}
std::uint32_t take_high(std::uint64_t x) {
  return static_cast<std::uint32_t>(x >> 32);
}

}  // namespace

std::array<std::uint32_t, 4> scramble(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
  for (int i = 0; i < rounds; ++i) {
    const std::uint64_t a = multiplier_0 * counter[0], b = multiplier_1 * counter[2];
    counter = {take_high(b) ^ counter[1] ^ key[0], take_low(b), take_high(a) ^ counter[3] ^ key[1], take_low(a)};
    key[0] += weyl_0;
    key[1] += weyl_1;
  }
  return counter;
}

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream)
    : key_{take_low(seed), take_high(seed)}, stream_(stream) {}

std::uint64_t RandomStream::draw_bits() {
  const std::uint64_t block = drawn_ / 2;
  if (drawn_ % 2 == 0)
    words_ = scramble({take_low(block), take_high(block), take_low(stream_), take_high(stream_)}, key_);
  const std::size_t first = 2 * (drawn_++ % 2);
  return (static_cast<std::uint64_t>(words_[first]) << 32) | words_[first + 1];
}

double RandomStream::draw_uniform() {
  return (static_cast<double>(draw_bits() >> 12) + 0.5) * 0x1p-52;  // 52 bits and a half: never 0 nor 1 after rounding
}

std::uint64_t RandomStream::draw_below(std::uint64_t count) {
  // Numbers above the largest multiple of `count` would favour the first remainders.
  const std::uint64_t usable = UINT64_MAX - UINT64_MAX % count;
  std::uint64_t bits = draw_bits();
  while (bits >= usable) bits = draw_bits();
  return bits % count;
}

}  // namespace talus::study
