// SPDX-License-Identifier: MIT
#pragma once
// Random numbers that do not depend on the compiler, unlike the standard distributions.

#include <random>

namespace talus::support {

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  /// Uniform between `from` and `to`.
  double operator()(double from, double to) {
    return from + (to - from) * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max());
  }

 private:
  std::mt19937 random_;
};

}  // namespace talus::support
