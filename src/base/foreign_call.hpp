// SPDX-License-Identifier: MIT
#pragma once
// Calls of compiled code that is not ours and runs in this process: a crash, a call that never returns and an end of
// the program are caught and named.

#include <cstddef>
#include <string>

namespace talus {

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

}  // namespace talus
