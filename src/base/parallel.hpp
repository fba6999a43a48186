// SPDX-License-Identifier: MIT
#pragma once
// The only place that knows threads. Work is cut into pieces that do not depend on the number of threads, each piece
// writes to its own memory, and sums over pieces are taken in the order of the pieces: results are bitwise the same
// for any number of threads.

#include <omp.h>

#include <exception>
#include <utility>

namespace talus {

namespace detail {

/// Runs pieces and keeps the first exception by piece number, since none may leave a parallel region.
template <class Work>
class GuardedWork {
 public:
  GuardedWork(int pieces, Work& work) : first_piece_(pieces), work_(work) {}
  void run(int piece) {
    try {
      work_(piece);
    } catch (...) {
#pragma omp critical(talus_parallel)
      if (piece < first_piece_) {
        first_piece_ = piece;
        first_ = std::current_exception();
      }
    }
  }
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  int first_piece_;
  Work& work_;
  std::exception_ptr first_;
};

}  // namespace detail

/// Calls work(0) … work(pieces-1), each once, on at most `threads` threads; waits for all. For many pieces of equal
/// size: a thread gets the same ones every time, so what it has in its cache stays useful. The first exception (by
/// piece number) is thrown again here.
template <class Work>
void parallel_for(int pieces, int threads, Work&& work) {
  if (threads <= 1 || pieces <= 1) {
    for (int i = 0; i < pieces; ++i) work(i);
    return;
  }
  detail::GuardedWork guarded(pieces, work);
#pragma omp parallel for num_threads(threads) schedule(static)
  for (int i = 0; i < pieces; ++i) guarded.run(i);
  guarded.rethrow();
}

/// The same for a few long pieces of unequal size, such as trials: a thread takes the next one when it is done.
template <class Work>
void parallel_tasks(int pieces, int threads, Work&& work) {
  if (threads <= 1 || pieces <= 1) {
    for (int i = 0; i < pieces; ++i) work(i);
    return;
  }
  detail::GuardedWork guarded(pieces, work);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (int i = 0; i < pieces; ++i) guarded.run(i);
  guarded.rethrow();
}

/// Threads of this machine that a run uses when the user names no number.
inline int default_threads() {
  return omp_get_max_threads();
}

}  // namespace talus
