// SPDX-License-Identifier: MIT
#pragma once
// Isolation of third-party code that may crash, never return or exhaust memory, in a child process or in this one, and
// loading of optional modules.

#include <spawn.h>

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

#include "base/message.hpp"

namespace talus {

/// The child ended before its work was complete. what() is the end of a sentence: "it crashed (Segmentation fault)".
struct ChildCrash : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Forks, runs `work` in the child and returns the message that it wrote. The child has a copy of the memory, one
/// thread, and at most the memory that is free. An Error of `work` is thrown here. If SIGINT or SIGTERM arrives
/// (base/progress.hpp), the child is killed and Error (interrupted) "interrupted while `doing`" is thrown within a
/// tenth of a second. Throws ChildCrash if the child crashes, and Error (no_memory) if it runs out of memory or cannot
/// be started.
Message do_in_child(const std::string& doing, const std::function<void(Message&)>& work);

/// Limits the processor time of the child [s], for libraries that may never return; it ends as by a crash. Other load
/// on the machine does not count.
void limit_processor_time(double seconds);

/// Limits the memory of the child to `bytes` beyond its current use, or to the free memory if that is less.
void limit_memory(double bytes);

/// Starts a program as posix_spawnp() does. It receives all signals, whatever the threads of this process block
/// (base/interrupts.cpp). Returns 0 or a value of errno.
int spawn_program(pid_t& child, const char* program, const posix_spawn_file_actions_t* actions, char* const* arguments);

// Calls of third-party compiled code in this process, which may crash, never return or end the program.

/// How a call ended.
enum class ForeignEnd { returned, crashed, never_returned };

/// Calls `function(data)`. Catches a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) and a call that has not returned
/// after one minute of this process's running time; effects of the code until then remain. If the code ends the program
/// (exit(), STOP in Fortran), a message with `name` is written to standard error and the exit code is 4. `function`
/// must own nothing that a destructor releases. Calls must be serialised in the process by a lock of the callers.
ForeignEnd call_foreign(const std::string& name, void (*function)(void*), void* data);

/// Replaces the limit of one minute [s], for tests.
void set_foreign_limit(double seconds);

/// Returns the signal of the last crash by its system name: "Segmentation fault".
std::string get_crash_name();

/// Memory for `count` numbers that ends at a guard page: accesses beyond it crash, and call_foreign() reports them.
/// Initially zero.
class GuardedArray {
 public:
  explicit GuardedArray(std::size_t count);
  GuardedArray(const GuardedArray&) = delete;
  GuardedArray& operator=(const GuardedArray&) = delete;
  ~GuardedArray();
  double* begin() const { return first_; }
  double* end() const { return first_ + count_; }
  double& operator[](std::size_t i) const { return first_[i]; }

 private:
  void* pages_ = nullptr;
  std::size_t bytes_ = 0;
  double* first_ = nullptr;
  std::size_t count_ = 0;
};

// Modules that are loaded at run time, because their dependencies are optional (MPI, CUDA) or slow to load (Gmsh).

/// Loads a module such as "libtalus_ranks.so" from the program's folder, from lib/talus of the installation or of the
/// Python package, or from where the loader looks, and returns its function `maker`. Returns nullptr with the reason in
/// `why` if there is no such module. Throws Error (wrong_input) if it is of another version. `global`: its symbols are
/// visible to libraries that it loads.
void* load_module(const std::string& name, const char* maker, bool global, std::string& why);

}  // namespace talus
