// SPDX-License-Identifier: MIT
// Progress reports for programs: every report is complete, they arrive one at a time and at a limited rate.

#include "base/progress.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace talus {
namespace {

TEST(Progress, CallsAListenerWithOneReportAtATime) {
  std::vector<ProgressReport> heard;
  std::atomic<int> inside{0};
  bool overlapped = false;
  Progress progress(Progress::Listener([&](const ProgressReport& report) {
    overlapped = overlapped || ++inside > 1;
    heard.push_back(report);
    --inside;
  }));
  testing::internal::CaptureStderr();
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&progress, t] {
      for (int i = 0; i < 100; ++i) progress.show({"a line", "[1 of 4] ", "trial", 1.0 * t, 10.0 * i});
    });
  for (std::thread& thread : threads) thread.join();
  progress.show("only a line");
  progress.clear();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_EQ(heard.size(), 401u);
  EXPECT_FALSE(overlapped);
  double sum = 0;
  for (const ProgressReport& report : heard) sum += report.time * report.duration;
  EXPECT_EQ(sum, (0 + 1 + 2 + 3) * 10.0 * 4950);
  EXPECT_EQ(heard.back().line, "only a line");
  EXPECT_EQ(heard.back().duration, 0);
}

TEST(Progress, IsDueAtOnceForAListenerAndThenNotForAWhile) {
  Progress progress(Progress::Listener([](const ProgressReport&) {}));
  EXPECT_TRUE(progress.is_due());
  const auto before = Progress::Clock::now();
  progress.show("a line");
  EXPECT_FALSE(progress.is_due(before + std::chrono::milliseconds(150)));
  EXPECT_TRUE(progress.is_due(Progress::Clock::now() + std::chrono::milliseconds(250)));
}

}  // namespace
}  // namespace talus
