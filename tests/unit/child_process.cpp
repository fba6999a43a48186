// SPDX-License-Identifier: MIT
// Work in a child process, and its normal and abnormal ends.
#include "base/foreign_code.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <numeric>
#include <thread>

#include "base/error.hpp"
#include "base/progress.hpp"

namespace talus {
namespace {

std::string catch_crash(const std::function<void(Message&)>& work) {
  try {
    do_in_child("the test was done", work);
  } catch (const ChildCrash& crash) {
    return crash.what();
  }
  return "no crash";
}

TEST(ChildProcess, GivesBackWhatItsWorkWrote) {
  std::vector<double> values(300000);  // more than a pipe holds
  std::iota(values.begin(), values.end(), 0.5);
  int seen = 7;
  Message message = do_in_child("the test was done", [&](Message& answer) {
    answer.put(seen);
    seen = 8;  // the child's own
    answer.put_list(values);
    answer.put_text("clay");
  });
  EXPECT_EQ(seen, 7);
  EXPECT_EQ(message.get<int>(), 7);
  EXPECT_EQ(message.get_list<double>(), values);
  EXPECT_EQ(message.get_text(), "clay");
  EXPECT_TRUE(message.is_read());
  EXPECT_THROW(message.get<char>(), std::out_of_range);
}

TEST(ChildProcess, ThrowsTheErrorOfItsWorkHere) {
  try {
    do_in_child("the test was done", [](Message&) { throw Error(ExitCode::wrong_input, "the file is no mesh"); });
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    EXPECT_STREQ(error.what(), "the file is no mesh");
  }
}

/// A child started by another thread does not keep a pipe open: some children wait until short ones, started later,
/// have returned.
TEST(ChildProcess, AnswersBeforeTheChildrenOfOtherThreadsEnd) {
  using Counter = std::atomic<int>;
  void* const shared = mmap(nullptr, sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  Counter& answered = *new (shared) Counter(0);
  std::atomic<bool> ends = false;
  std::thread short_ones([&] {
    while (!ends) {
      do_in_child("nothing was done", [](Message&) {});
      ++answered;
    }
  });
  for (int i = 0; i < 100; ++i) {
    const int before = answered;
    do_in_child("others were answered", [&](Message&) {
      while (answered < before + 3) sched_yield();
    });
  }
  ends = true;
  short_ones.join();
  munmap(shared, sizeof(Counter));
}

TEST(ChildProcess, EndsAfterItsTimeOfTheProcessor) {
  EXPECT_EQ(catch_crash([](Message&) {
              limit_processor_time(1);
              for (volatile int turns = 0;;) turns = turns ^ 1;
            }),
            "it crashed (CPU time limit exceeded)");
}

TEST(ChildProcess, ReportsHowItEndedWhereItsWorkDidNot) {
  EXPECT_EQ(catch_crash([](Message&) { std::abort(); }), "it crashed (Aborted)");
  EXPECT_EQ(catch_crash([](Message&) { _exit(3); }), "it ended by itself with code 3");
  EXPECT_EQ(catch_crash([](Message&) { raise(SIGSEGV); }), "it crashed (Segmentation fault)");
  EXPECT_EQ(catch_crash([](Message&) { raise(SIGKILL); }),
            "it was killed from outside, as a machine without free memory does");
  EXPECT_EQ(catch_crash([](Message&) { throw std::runtime_error("no such curve"); }), "no such curve");
  EXPECT_EQ(catch_crash([](Message&) { throw 4; }), "for a reason that it did not give");
}

TEST(ChildProcess, IsKilledWhenASignalArrives) {
  const auto make_and_wait_result = [](Message&) {
    kill(getppid(), SIGUSR1);
    for (;;) pause();
  };
  std::signal(SIGUSR1, [](int) { request_interrupt(); });
  try {
    do_in_child("the mesh was made", make_and_wait_result);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::interrupted);
    EXPECT_STREQ(error.what(), "interrupted while the mesh was made");
  }
  std::signal(SIGUSR1, SIG_DFL);
  request_interrupt(false);
}

}  // namespace
}  // namespace talus
