// SPDX-License-Identifier: MIT
#pragma once
// Parallel loops; the only place that uses threads. The division into pieces does not depend on the number of threads,
// each piece writes to its own memory, and sums over pieces are taken in their order, so results are bitwise identical
// for any number of threads.

#ifdef _OPENMP
#include <omp.h>
#endif

#include <exception>

namespace talus {

namespace detail {

/// Calls work with the number of the thread too, if it takes it.
void call(auto& work, int piece, int thread) {
  if constexpr (requires { work(piece, thread); })
    work(piece, thread);
  else
    work(piece);
}

/// Runs pieces and stores the exception of the lowest piece, since exceptions must not leave a parallel region.
template <class Work>
class GuardedWork {
 public:
  GuardedWork(int pieces, Work& work) : first_piece_(pieces), work_(work) {}
  void run(int piece) {
    try {
#ifdef _OPENMP
      call(work_, piece, omp_get_thread_num());
#else
      call(work_, piece, 0);
#endif
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

/// Calls work(0) … work(pieces-1) once each on at most `threads` threads and waits for all. It suits many pieces of
/// equal cost: the static schedule assigns the same pieces to a thread every time, which reuses its cache. Rethrows the
/// exception of the lowest piece.
void parallel_for(int pieces, int threads, auto&& work) {
  if (threads <= 1 || pieces <= 1) {
    for (int i = 0; i < pieces; ++i) work(i);
    return;
  }
  detail::GuardedWork guarded(pieces, work);
#pragma omp parallel for num_threads(threads) schedule(static)
  for (int i = 0; i < pieces; ++i) guarded.run(i);
  guarded.rethrow();
}

/// As parallel_for() for few pieces of unequal cost, such as trials, with a dynamic schedule. `work` may take the
/// number of the thread, below `threads`, as a second argument, for memory that the pieces of a thread share.
void parallel_tasks(int pieces, int threads, auto&& work) {
  if (threads <= 1 || pieces <= 1) {
    for (int i = 0; i < pieces; ++i) detail::call(work, i, 0);
    return;
  }
  detail::GuardedWork guarded(pieces, work);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (int i = 0; i < pieces; ++i) guarded.run(i);
  guarded.rethrow();
}

/// Returns the default number of threads.
inline int default_threads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

}  // namespace talus
