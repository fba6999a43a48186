// SPDX-License-Identifier: MIT
#include "base/foreign_code.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <omp.h>
#include <poll.h>
#include <pthread.h>
#include <setjmp.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <mutex>
#include <new>
#include <optional>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/numbers.hpp"
#include "base/progress.hpp"
#include "base/user_file.hpp"

#ifdef __linux__
#include <sys/auxv.h>
#include <sys/prctl.h>
#endif

namespace talus {
namespace {

/// Longest delay of the reaction to a signal [ms].
constexpr int look = 50;
constexpr std::size_t portion = 1 << 16;

/// How the work ended; first byte of the message to the parent.
enum class End : char { done, error, no_memory, other };

/// Writes the result to the pipe in the child. It does not throw, because no caller could catch.
void send(int pipe, End end, const std::vector<std::byte>& bytes) {
  const auto write_all = [pipe](const void* data, std::size_t size) {
    const char* rest = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t n = ::write(pipe, rest, size);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) _exit(1);  // the parent has closed the pipe
      rest += n;
      size -= static_cast<std::size_t>(n);
    }
  };
  write_all(&end, 1);
  write_all(bytes.data(), bytes.size());
}

/// Isolates the child from the system: no core dump, no more memory than is free, and termination with the parent.
void become_harmless([[maybe_unused]] pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // the parent ended before prctl()
#endif
  // The parent terminates the child, even if a terminal sends the signal to both.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(crash, SIG_DFL);
  std::set_terminate([] { std::abort(); });  // without a message on stderr
#ifndef __SANITIZE_ADDRESS__
  // Messages of a library or of the system about a crash are suppressed; the user gets the message of this program.
  if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
#endif
  const rlimit no_dump{0, 0};
  setrlimit(RLIMIT_CORE, &no_dump);
  rlimit memory{};
  if (const std::optional<double> room = find_address_room(); room && getrlimit(RLIMIT_AS, &memory) == 0) {
    memory.rlim_cur = std::min(memory.rlim_cur, static_cast<rlim_t>(*room));  // the user's limit still applies
    setrlimit(RLIMIT_AS, &memory);
  }
  // The threads of the parent's pool do not exist in the child.
  omp_set_num_threads(1);
}

[[noreturn]] void be_child(int pipe, pid_t parent, const std::function<void(Message&)>& work) {
  become_harmless(parent);
  Message answer;
  try {
    work(answer);
    send(pipe, End::done, answer.bytes());
  } catch (const Error& error) {
    Message said;
    said.put(error.code());
    said.put_text(error.what());
    send(pipe, End::error, said.bytes());
  } catch (const std::bad_alloc&) {
    send(pipe, End::no_memory, {});
  } catch (const std::exception& error) {
    Message said;
    said.put_text(error.what());
    send(pipe, End::other, said.bytes());
  } catch (...) {
    send(pipe, End::other, {});
  }
  _exit(0);
}

/// A child process that is waited for in the destructor.
class Child {
 public:
  explicit Child(pid_t id) : id_(id) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    wait();
  }
  /// Returns the status of waitpid(); 0 if the host program of this library reaps all children.
  int wait() {
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
    return status;
  }

 private:
  pid_t id_;
};

struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() = default;
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    for (int& end : ends) close(end);
  }
  static void close(int& end) {
    if (end >= 0) ::close(end);
    end = -1;
  }
};

/// Returns all bytes from the child. Throws Error (interrupted) if a signal arrives, unless `was_interrupted`: it was
/// pending before the child was started.
std::vector<std::byte> receive(int pipe, const std::string& doing, bool was_interrupted) {
  std::vector<std::byte> bytes;
  for (;;) {
    if (!was_interrupted && is_interrupted()) throw Error(ExitCode::interrupted, "interrupted while {}", doing);
    pollfd event{pipe, POLLIN, 0};
    if (::poll(&event, 1, look) <= 0) continue;
    const std::size_t had = bytes.size();
    bytes.resize(had + portion);
    const ssize_t n = ::read(pipe, bytes.data() + had, portion);
    bytes.resize(had + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    if (n == 0) return bytes;
    if (n < 0 && errno != EINTR) throw ChildCrash(fmt::format("its answer was lost ({})", std::strerror(errno)));
  }
}

std::string describe_end(int status) {
  if (WIFSIGNALED(status)) {
    if (WTERMSIG(status) == SIGKILL) return "it was killed from outside, as a machine without free memory does";
    return fmt::format("it crashed ({})", strsignal(WTERMSIG(status)));
  }
  return fmt::format("it ended by itself with code {}", WEXITSTATUS(status));
}

[[noreturn]] void cannot_start() {
  refuse_full_file_table(errno);
  throw Error(ExitCode::no_memory, "cannot start a process: {}", std::strerror(errno));
}

/// Forks, one thread at a time: a child started meanwhile by another thread would inherit the write end of this pipe,
/// so that end-of-file would be delayed until that other child ends.
pid_t start_child(Pipe& pipe, const std::function<void(Message&)>& work) {
  static std::mutex one_at_a_time;
  std::unique_lock lock(one_at_a_time);
  if (::pipe(pipe.ends.data()) != 0) cannot_start();
  for (const int end : pipe.ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  const pid_t parent = ::getpid();
  const PlainNumbers plain;  // Gmsh reads numbers by the locale
  const pid_t id = ::fork();
  if (id < 0) cannot_start();
  if (id == 0) {
    lock.unlock();  // `work` may start children of its own
    Pipe::close(pipe.ends[0]);
    be_child(pipe.ends[1], parent, work);
  }
  Pipe::close(pipe.ends[1]);
  return id;
}

}  // namespace

void limit_processor_time(double seconds) {
  rlimit time{};
  if (getrlimit(RLIMIT_CPU, &time) != 0) return;
  time.rlim_cur = std::min(time.rlim_cur, static_cast<rlim_t>(seconds));
  std::signal(SIGXCPU, SIG_DFL);
  setrlimit(RLIMIT_CPU, &time);
}

void limit_memory(double bytes) {
  const std::optional<double> size = find_address_size();
  rlimit memory{};
  if (!size || getrlimit(RLIMIT_AS, &memory) != 0) return;
  memory.rlim_cur = std::min(memory.rlim_cur, static_cast<rlim_t>(*size + bytes));
  setrlimit(RLIMIT_AS, &memory);
}

Message do_in_child(const std::string& doing, const std::function<void(Message&)>& work) {
  // With an interruption pending already, the work is completed; the caller checks for the interruption afterwards.
  const bool was_interrupted = is_interrupted();
  Pipe pipe;
  Child child(start_child(pipe, work));
  std::vector<std::byte> bytes = receive(pipe.ends[0], doing, was_interrupted);
  const int status = child.wait();
  if (bytes.empty() || !WIFEXITED(status) || WEXITSTATUS(status) != 0) throw ChildCrash(describe_end(status));
  const End end = static_cast<End>(bytes.front());
  bytes.erase(bytes.begin());
  Message said(std::move(bytes));
  if (end == End::done) return said;
  if (end == End::no_memory)
    throw Error(ExitCode::no_memory, "the machine has not enough free memory: it ended while {}", doing);
  if (end == End::other) throw ChildCrash(said.is_read() ? "for a reason that it did not give" : said.get_text());
  const ExitCode code = said.get<ExitCode>();
  throw Error(code, said.get_text());
}

int spawn_program(pid_t& child, const char* program, const posix_spawn_file_actions_t* actions,
                  char* const* arguments) {
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  const int failure = posix_spawnp(&child, program, actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  return failure;
}

}  // namespace talus

namespace talus {

namespace {

/// Number of checks until a call counts as one that never returns. A stopped process does not check, so a pause of the
/// process does not count.
constexpr int most_looks = 12;
constexpr double usual_limit = 60;  ///< [s]
std::atomic<double> limit{usual_limit};

constexpr std::array crashes{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
/// Returns the signal that the watch thread sends to the thread of a call that does not return.
int get_watch_signal() {
  return SIGRTMAX - 1;
}

/// State of the running call, shared by the signal handlers and the watch thread.
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

void leave_call(int signal) {
  if (is_ours()) siglongjmp(running.back, signal);
  if (signal == get_watch_signal()) return;  // the call has returned meanwhile
  // The crash is not in foreign code: restore the previous handler.
  for (std::size_t i = 0; i < crashes.size(); ++i)
    if (crashes[i] == signal) sigaction(signal, &before[i], nullptr);
  if (signal == SIGABRT) std::raise(signal);
}

/// Runs inside exit(), which cannot be cancelled; only the message is replaced.
void handle_exit() {
  if (!is_ours()) return;
  const auto say = [](const char* text) { static_cast<void>(::write(STDERR_FILENO, text, std::strlen(text)) < 0); };
  say("talus: error: ");
  say(running.name);
  say(" ended the program, as STOP or exit() do. Results that were written are whole. ");
  say("--resume continues from the last checkpoint\n");
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
  action.sa_handler = leave_call;
  action.sa_flags = SA_ONSTACK | SA_NODEFER;  // the signal is not blocked after siglongjmp()
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < crashes.size(); ++i) sigaction(crashes[i], &action, &before[i]);
  sigaction(get_watch_signal(), &action, nullptr);
  std::atexit(handle_exit);
  std::thread(watch).detach();
  return true;
}

/// An alternate signal stack, for calls that overflow the stack of the thread.
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
  alignas(16) std::array<char, 1 << 16> bytes;  // the address sanitizer poisons it by words
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

namespace {

/// Returns the folders in which modules are searched: for the program, its own folder and that of the installation; for
/// the library loaded by Python, its own folder, the package (above the folder of the instruction-set level) and the
/// build tree.
std::vector<std::string> list_folders() {
  Dl_info own{};
  std::error_code ignored;
  const bool known = dladdr(reinterpret_cast<void*>(&list_folders), &own) != 0 && own.dli_fname != nullptr;
  std::filesystem::path file = known ? std::filesystem::canonical(own.dli_fname, ignored) : "";
  const bool is_library = file.extension() == ".so";
#ifdef __linux__
  // For a program dladdr() returns argv[0], which need not be a path. AT_EXECFN is for systems without /proc.
  if (!is_library) file = std::filesystem::read_symlink("/proc/self/exe", ignored);
  // NOLINTNEXTLINE(performance-no-int-to-ptr): the kernel gives addresses as numbers
  if (file.empty()) file = std::filesystem::canonical(reinterpret_cast<const char*>(getauxval(AT_EXECFN)), ignored);
#endif
  const std::string folder = file.parent_path().string();
  if (is_library) return {folder + "/", folder + "/../../../talus/", folder + "/../", folder + "/../../bin/"};
  return {folder + "/", folder + "/../lib/talus/"};
}

}  // namespace

void* load_module(const std::string& name, const char* maker, bool global, std::string& why) {
  void* library = nullptr;
  std::vector<std::string> paths = list_folders();
  for (std::string& path : paths) path += name;
  paths.push_back(name);  // where the loader looks: a program built on the library has the folder of modules as rpath
  for (const std::string& path : paths) {
    library = dlopen(path.c_str(), RTLD_NOW | (global ? RTLD_GLOBAL : RTLD_LOCAL));
    if (library != nullptr) break;
    if (why.empty() || std::filesystem::exists(path)) why = dlerror();
  }
  if (library == nullptr) return nullptr;
  void* function = dlsym(library, maker);
  if (function == nullptr) fail_input(name + " is of another version");
  return function;
}

}  // namespace talus
