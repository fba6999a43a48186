// SPDX-License-Identifier: MIT
#pragma once
// Work of libraries that may crash, never end or take all memory: done by a child process, which cannot harm this one.

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

#include "base/message.hpp"

namespace talus {

/// The child ended before its work did. what() says how, as the end of a sentence: "it crashed (Segmentation fault)".
struct ChildCrash : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Forks, does `work` in the child and returns the bytes that it wrote. The child sees all memory as it is now, and
/// what it changes there is lost; it has one thread and the memory that is free. An Error that `work` throws is thrown
/// here. When SIGINT or SIGTERM arrives meanwhile (base/progress.hpp), the child is killed and Error (interrupted)
/// thrown within a tenth of a second: "interrupted while `doing`". Throws ChildCrash when the child crashes, and Error
/// (no_memory) when it finds no memory or cannot be started.
std::vector<std::byte> do_in_child(const std::string& doing, const std::function<void(ByteWriter&)>& work);

/// For such work: ends its process as a crash does after so many seconds of the processor's time, where a library may
/// never return. A busy machine does not shorten them.
void limit_processor_time(double seconds);

/// The same for memory: its process gets so many bytes beside what it has, or what is free if that is less.
void limit_memory(double bytes);

// Calls of compiled code that is not ours and runs in this process: a crash, a call that never returns and an end of
// the program are caught and named.

/// How a call ended.
enum class ForeignEnd { returned, crashed, never_returned };

/// Calls `function(data)`. A crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) is caught, and so is a call that has not
/// returned after a minute in which this process ran; what the code did until then stays done. Where it ends the
/// program (exit(), STOP of Fortran), the program says so with `name` on standard error and ends with code 4.
/// `function` must hold nothing that a destructor frees. One call at a time in the process: callers hold a lock.
ForeignEnd call_foreign(const std::string& name, void (*function)(void*), void* data);

/// Another limit than a minute [s], for tests.
void set_foreign_limit(double seconds);

/// The signal of the last call that crashed, as the system names it: "Segmentation fault".
std::string get_crash_name();

/// Memory for `count` numbers that ends where memory of this process ends: who writes or reads behind it crashes, and
/// call_foreign() tells. Zero at first.
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

// Parts of the program that are loaded where they are asked for, because what they need is not everywhere: MPI, CUDA.

/// Loads a module such as "libtalus_ranks.so", which stands beside the program or in the folder lib/talus of where it
/// or Python's package is installed, and returns its function `maker`. nullptr where there is no such module, and `why`
/// says what was the matter. Throws Error (wrong_input) where it is of another version. `global`: its symbols serve
/// what it loads itself.
void* load_module(const std::string& name, const char* maker, bool global, std::string& why);

}  // namespace talus
