// SPDX-License-Identifier: MIT
#pragma once
// Random numbers from a counter: the same on every machine, for any number of threads, and independent between streams.

#include <array>
#include <cstdint>

namespace talus::study {

/// Philox4x32-10 (Salmon, Moraes, Dror and Shaw 2011): four random words of a counter of four and a key of two.
std::array<std::uint32_t, 4> scramble(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// The random numbers of one seed and one stream number, in their order.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t stream);

  std::uint64_t draw_bits();
  /// Uniform in (0, 1), both ends excluded, in steps of 2⁻⁵².
  double draw_uniform();
  /// Uniform among 0 … count-1, without bias.
  std::uint64_t draw_below(std::uint64_t count);

 private:
  std::array<std::uint32_t, 2> key_;
  std::uint64_t stream_, drawn_ = 0;
  std::array<std::uint32_t, 4> words_{};
};

}  // namespace talus::study
