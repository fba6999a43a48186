// SPDX-License-Identifier: MIT
// A signal that arrives while METIS has replaced the handlers of the process is not lost, and the order stays the same.

#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <vector>

#include "base/progress.hpp"
#include "sparse/elimination.hpp"

namespace talus {
namespace {

/// The pattern of a grid of n × n × n nodes, by compressed columns; large enough for nested dissection.
struct Grid {
  std::vector<int> start{0}, row;

  explicit Grid(int n) {
    const int rows = n * n * n;
    for (int i = 0; i < rows; ++i) {
      const int x = i % n, y = i / n % n, z = i / (n * n);
      const auto add = [&](bool is_inside, int other) {
        if (is_inside) row.push_back(other);
      };
      add(z > 0, i - n * n), add(y > 0, i - n), add(x > 0, i - 1), add(true, i);
      add(x + 1 < n, i + 1), add(y + 1 < n, i + n), add(z + 1 < n, i + n * n);
      start.push_back(static_cast<int>(row.size()));
    }
  }
};

auto get_handler() {
  struct sigaction now {};
  sigaction(SIGTERM, nullptr, &now);
  return now.sa_handler;
}

/// Plans an elimination in the main thread or in another one, and sends SIGTERM to the process when the handler is that
/// of METIS. Ends the process with 0 if the signal was noticed and the plan is that without it.
[[noreturn]] void plan_and_send(bool is_main) {
  const Grid grid(36);
  const std::vector<int> expected = sparse::plan_elimination(grid.start, grid.row).position;
  catch_interrupts();
  const auto ours = get_handler();
  std::atomic<bool> has_ended{false}, is_sent{false};
  std::thread sender([&] {
    while (get_handler() == ours && !has_ended) sched_yield();
    if (has_ended) return;
    is_sent = true;
    kill(getpid(), SIGTERM);
  });
  std::vector<int> found;
  const auto plan = [&] { found = sparse::plan_elimination(grid.start, grid.row).position; };
  if (is_main)
    plan();
  else
    std::thread(plan).join();
  has_ended = true;
  sender.join();
  constexpr int most_looks = 10'000'000;  // of a thread that has nothing else to do
  for (int looks = 0; looks < most_looks && !is_interrupted(); ++looks) sched_yield();
  std::_Exit(!is_sent ? 3 : !is_interrupted() ? 2 : found == expected ? 0 : 1);
}

TEST(Interrupts, ArriveDuringNestedDissection) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(plan_and_send(true), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(plan_and_send(false), testing::ExitedWithCode(0), "");
}

TEST(Interrupts, ASecondSignalEndsTheProgram) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      {
        catch_interrupts();
        kill(getpid(), SIGTERM);
        while (!is_interrupted()) sched_yield();
        kill(getpid(), SIGTERM);
        for (;;) pause();
      },
      testing::KilledBySignal(SIGTERM), "");
}

}  // namespace
}  // namespace talus
