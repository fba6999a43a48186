// SPDX-License-Identifier: MIT
#include "base/foreign_call.hpp"

#include <pthread.h>
#include <setjmp.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <thread>

#include "base/error.hpp"

namespace talus {
namespace {

/// A call that has not returned is looked at so often. A process that is stopped does not look, so that a pause does
/// not count.
constexpr int most_looks = 12;
constexpr double usual_limit = 60;  ///< [s]
std::atomic<double> limit{usual_limit};

constexpr std::array crashes{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
/// What the watch sends to the thread of a call that does not return.
int get_watch_signal() {
  return SIGRTMAX - 1;
}

/// The call that runs; handlers and the watch look at it.
struct Running {
  sigjmp_buf back;
  std::atomic<bool> is_on{false};
  std::atomic<pthread_t> thread{};
  std::atomic<unsigned long> number{0};
  const char* name = "";
};
Running running;
std::array<struct sigaction, crashes.size()> before;
int last_crash = 0;

bool is_ours() {
  return running.is_on.load() && pthread_equal(running.thread, pthread_self()) != 0;
}

void handle(int signal) {
  if (is_ours()) siglongjmp(running.back, signal);
  if (signal == get_watch_signal()) return;  // the call returned meanwhile
  // Somebody else's crash: as it would have been without this.
  for (std::size_t i = 0; i < crashes.size(); ++i)
    if (crashes[i] == signal) sigaction(signal, &before[i], nullptr);
  if (signal == SIGABRT) std::raise(signal);
}

/// exit() is in progress and cannot be left, so only the sentence is ours.
void handle_exit() {
  if (!is_ours()) return;
  const auto say = [](const char* text) { static_cast<void>(::write(STDERR_FILENO, text, std::strlen(text)) < 0); };
  say("talus: error: ");
  say(running.name);
  say(" ended the program, as STOP or exit() do. Results that were written are whole. ");
  say("--resume goes on from the last checkpoint\n");
  std::_Exit(static_cast<int>(ExitCode::unstable));
}

void watch() {
  unsigned long seen = 0;
  for (int looks = 0;; std::this_thread::sleep_for(std::chrono::duration<double>(limit.load() / most_looks))) {
    const unsigned long now = running.number.load();
    looks = running.is_on.load() && now == seen ? looks + 1 : 0;
    seen = now;
    if (looks < most_looks) continue;
    pthread_kill(running.thread, get_watch_signal());
    looks = 0;
  }
}

bool prepare_process() {
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = SA_ONSTACK | SA_NODEFER;  // no signal stays blocked after the way back
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < crashes.size(); ++i) sigaction(crashes[i], &action, &before[i]);
  sigaction(get_watch_signal(), &action, nullptr);
  std::atexit(handle_exit);
  std::thread(watch).detach();
  return true;
}

/// A stack of its own for the handler, where the call has used up this thread's.
struct HandlerStack {
  HandlerStack() {
    stack_t stack{};
    stack.ss_size = bytes.size();
    stack.ss_sp = bytes.data();
    sigaltstack(&stack, nullptr);
  }
  ~HandlerStack() {
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
  }
  alignas(16) std::array<char, 1 << 16> bytes;  // the address sanitizer marks it by words
};

}  // namespace

ForeignEnd call_foreign(const std::string& name, void (*function)(void*), void* data) {
  static const bool is_prepared = prepare_process();
  static_cast<void>(is_prepared);
  thread_local HandlerStack stack;
  running.name = name.c_str();
  running.thread = pthread_self();
  running.number.fetch_add(1);
  if (const int signal = sigsetjmp(running.back, 0); signal != 0) {
    running.is_on.store(false);
    if (signal == get_watch_signal()) return ForeignEnd::never_returned;
    last_crash = signal;
    return ForeignEnd::crashed;
  }
  running.is_on.store(true);
  function(data);
  running.is_on.store(false);
  return ForeignEnd::returned;
}

void set_foreign_limit(double seconds) {
  limit.store(seconds);
}

std::string get_crash_name() {
  return strsignal(last_crash);
}

GuardedArray::GuardedArray(std::size_t count) : count_(count) {
  const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), wanted = count * sizeof(double);
  const std::size_t open = (wanted + page - 1) / page * page;
  bytes_ = open + 2 * page;
  pages_ = mmap(nullptr, bytes_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages_ == MAP_FAILED) throw std::bad_alloc();
  char* first = static_cast<char*>(pages_) + page;
  if (open > 0 && mprotect(first, open, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
  first_ = reinterpret_cast<double*>(first + open - wanted);
}

GuardedArray::~GuardedArray() {
  munmap(pages_, bytes_);
}

}  // namespace talus
