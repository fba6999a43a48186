// SPDX-License-Identifier: MIT
#include "base/abandon.hpp"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "base/error.hpp"
#include "base/interrupt.hpp"

namespace talus {
namespace {

using namespace std::chrono_literals;

/// How long a signal may wait.
constexpr auto look = 50ms;

std::atomic<int> abandoned{0};

struct Job {
  std::mutex changing;
  std::condition_variable ended;
  bool is_done = false, is_abandoned = false;
  std::exception_ptr failure;
};

void do_job(const std::shared_ptr<Job>& job, const std::function<void()>& work) {
  std::exception_ptr failure;
  try {
    work();
  } catch (...) {
    failure = std::current_exception();
  }
  const std::lock_guard lock(job->changing);
  job->failure = failure;
  job->is_done = true;
  if (job->is_abandoned) --abandoned;
  job->ended.notify_all();
}

}  // namespace

void do_or_abandon(const std::string& doing, std::function<void()> work) {
  const auto job = std::make_shared<Job>();
  // Who called with an interruption pending wants this work done, and looks for it afterwards.
  const bool was_interrupted = is_interrupted();
  std::thread thread([job, work = std::move(work)] { do_job(job, work); });
  std::unique_lock lock(job->changing);
  while (!job->ended.wait_for(lock, look, [&] { return job->is_done; })) {
    if (was_interrupted || !is_interrupted()) continue;
    job->is_abandoned = true;
    ++abandoned;
    thread.detach();
    throw Error(ExitCode::interrupted, fmt::format("interrupted while {}", doing));
  }
  lock.unlock();
  thread.join();
  if (job->failure) std::rethrow_exception(job->failure);
}

bool is_work_abandoned() {
  return abandoned.load() > 0;
}

}  // namespace talus
