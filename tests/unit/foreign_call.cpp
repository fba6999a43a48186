// SPDX-License-Identifier: MIT
// Calls of foreign code that crashes, does not return, or ends the program.
#include "base/foreign_code.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace talus {
namespace {

TEST(ForeignCall, ComesBackFromWhatTheCodeDoes) {
  int calls = 0;
  const auto count = [](void* data) { ++*static_cast<int*>(data); };
  EXPECT_EQ(call_foreign("a test", count, &calls), ForeignEnd::returned);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(call_foreign(
                "a test", [](void*) { std::abort(); }, nullptr),
            ForeignEnd::crashed);
  EXPECT_EQ(get_crash_name(), "Aborted");
  EXPECT_EQ(call_foreign(
                "a test", [](void*) { raise(SIGFPE); }, nullptr),
            ForeignEnd::crashed);
  EXPECT_EQ(get_crash_name(), "Floating point exception");
  GuardedArray array(3);
  const auto fill = [](void* data) {
    const GuardedArray& a = *static_cast<GuardedArray*>(data);
    for (double* x = a.begin(); x <= a.end(); ++x) *x = 2;
  };
  EXPECT_EQ(array[2], 0);
  EXPECT_EQ(call_foreign("a test", fill, &array), ForeignEnd::crashed);
  EXPECT_EQ(get_crash_name(), "Segmentation fault");
  EXPECT_EQ(array[2], 2) << "what it did until then stays done";
  EXPECT_EQ(call_foreign("a test", count, &calls), ForeignEnd::returned);
}

TEST(ForeignCall, EndsACallThatDoesNotReturn) {
  set_foreign_limit(0.2);
  EXPECT_EQ(call_foreign(
                "a test",
                [](void*) {
                  for (;;) pause();
                },
                nullptr),
            ForeignEnd::never_returned);
  set_foreign_limit(60);
}

TEST(ForeignCall, ReportsWhoEndedTheProgram) {
  EXPECT_EXIT(call_foreign(
                  "the external model of 'clay'", [](void*) { std::exit(0); }, nullptr),
              testing::ExitedWithCode(4), "talus: error: the external model of 'clay' ended the program, as STOP");
}

}  // namespace
}  // namespace talus
