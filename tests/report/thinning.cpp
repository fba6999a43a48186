// SPDX-License-Identifier: MIT
// The selection of frames and points for a report.

#include "report/content/sequence.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace talus::report {
namespace {

TEST(Thinning, FirstAndLastFrameStayAndTheRestIsSpread) {
  for (const std::size_t count : {1u, 2u, 5u, 47u, 48u, 49u, 50u, 95u, 96u, 1000u}) {
    const auto chosen = choose_frames(count, 48);
    ASSERT_EQ(chosen.size(), std::min<std::size_t>(count, 48));
    EXPECT_EQ(chosen.front(), 0u);
    EXPECT_EQ(chosen.back(), count - 1);
    const double gap = count > 48 ? static_cast<double>(count - 1) / 47 : 1;
    for (std::size_t k = 1; k < chosen.size(); ++k) {
      EXPECT_GT(chosen[k], chosen[k - 1]);
      EXPECT_NEAR(static_cast<double>(chosen[k] - chosen[k - 1]), gap, 1);
    }
  }
  EXPECT_EQ(choose_frames(9, 3), (std::vector<std::size_t>{0, 4, 8}));
}

TEST(Thinning, TheStrideIsTheSmallestThatKeepsTheLimits) {
  const Budget budget{48, 20000, 300000};
  EXPECT_EQ(choose_stride(5343, 41, budget), 1u);
  EXPECT_EQ(choose_stride(20000, 1, budget), 1u);
  EXPECT_EQ(choose_stride(20001, 1, budget), 2u);
  for (const std::size_t points : {6250u, 6251u, 100000u, 1234567u}) {
    const std::size_t stride = choose_stride(points, 48, budget);
    EXPECT_LE((points + stride - 1) / stride * 48, 300000u);
    if (stride > 1) {
      EXPECT_GT((points + stride - 2) / (stride - 1) * 48, 300000u);
    }
  }
}

TEST(Thinning, WhatOneSequenceLeavesTheOthersGet) {
  EXPECT_EQ(share_out({10, 500, 200}, 600), (std::vector<std::size_t>{10, 390, 200}));
  EXPECT_EQ(share_out({500, 500}, 600), (std::vector<std::size_t>{300, 300}));
  EXPECT_EQ(share_out({1, 2, 3}, 600), (std::vector<std::size_t>{1, 2, 3}));
  EXPECT_EQ(share_out({}, 600), std::vector<std::size_t>{});
}

TEST(Thinning, TheSentenceStatesWhatWasOmitted) {
  EXPECT_EQ(describe_thinning(14, 14, 5343, 5343, 1), "All 14 frames with all 5343 points.");
  const std::string thin = describe_thinning(120, 48, 21372, 5343, 4);
  for (const char* part : {"48 of 120 frames", "5343 of 21372 points", "multiple of 4", "results file"})
    EXPECT_NE(thin.find(part), std::string::npos) << thin;
}

}  // namespace
}  // namespace talus::report
