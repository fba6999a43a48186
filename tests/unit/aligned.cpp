// SPDX-License-Identifier: MIT
// Aligned arrays, of which only written pages occupy memory.

#include "base/aligned.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <fstream>

namespace talus {
namespace {

/// Memory of this process that is there [bytes].
double find_resident() {
  double all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

constexpr std::size_t many = 20'000'000;  // 160 MB
constexpr double little = 20e6;

TEST(Aligned, ZerosTakeNoMemoryUntilTheyAreWritten) {
  const double before = find_resident();
  AlignedVector<double> zeros(many), assigned;
  assigned.assign(many, 0.0);
  AlignedVector<double> copy = zeros;
  copy[many / 2] = 1;
  const AlignedVector<double> again = copy;
  EXPECT_LT(find_resident() - before, little);
  EXPECT_EQ(again[many / 2], 1);
  EXPECT_EQ(again[many / 2 + 1], 0);
}

TEST(Aligned, ArraysHoldWhatTheyAreGiven) {
  for (const std::size_t count : {3, 1'000'000}) {
    AlignedVector<double> values(count, -0.0);
    EXPECT_TRUE(std::signbit(values.back()));
    values.clear();
    values.resize(count);
    EXPECT_FALSE(std::signbit(values.back()));
    values.assign(count, 2.5);
    values.resize(2 * count, 3.5);
    EXPECT_EQ(values[count - 1], 2.5);
    EXPECT_EQ(values[2 * count - 1], 3.5);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(values.data()) % 64, 0u);
  }
}

}  // namespace
}  // namespace talus
