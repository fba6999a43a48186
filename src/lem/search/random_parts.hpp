// SPDX-License-Identifier: MIT
#pragma once
// Numbers between -1 and 1 that move the starts of a search: the same ones on every machine.

#include <random>

namespace talus::lem {

class RandomParts {
 public:
  /// Seeds side by side begin with near numbers in this generator, so they are spread.
  explicit RandomParts(int seed) : random_(1 + 104729u * static_cast<std::minstd_rand::result_type>(seed)) {}

  /// The next one. The standard's distributions differ between libraries; its generators do not.
  double draw() {
    constexpr double first = std::minstd_rand::min(), last = std::minstd_rand::max();
    return 2 * (static_cast<double>(random_()) - first) / (last - first) - 1;
  }

 private:
  std::minstd_rand random_;
};

}  // namespace talus::lem
