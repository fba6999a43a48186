// SPDX-License-Identifier: MIT
#pragma once
// The time of the lines of a step.

#include <chrono>

namespace talus::mpm {

/// Runs lines one after the other, and adds the time since the last one, or since its making, to a part of the step.
class Stopwatch {
 public:
  template <class Line>
  void operator()(double& part, Line&& line) {
    line();
    const auto now = std::chrono::steady_clock::now();
    part += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace talus::mpm
