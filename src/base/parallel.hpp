#pragma once
// The only place that knows threads. Work is cut into pieces that do not depend on the number of threads, each piece
// writes to its own memory, and sums over pieces are taken in the order of the pieces: results are bitwise the same
// for any number of threads.

#include <omp.h>

#include <exception>
#include <utility>

namespace talus {

/// Calls work(0) … work(pieces-1), each once, on at most `threads` threads; waits for all. The pieces may run in any
/// order. The first exception (by piece number) is thrown again here.
template <class Work>
void parallel_for(int pieces, int threads, Work&& work) {
  if (threads <= 1 || pieces <= 1) {
    for (int i = 0; i < pieces; ++i) work(i);
    return;
  }
  std::exception_ptr first;
  int first_piece = pieces;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (int i = 0; i < pieces; ++i) {
    try {
      work(i);
    } catch (...) {
#pragma omp critical(talus_parallel_for)
      if (i < first_piece) {
        first_piece = i;
        first = std::current_exception();
      }
    }
  }
  if (first) std::rethrow_exception(first);
}

/// Threads of this machine that a run uses when the user names no number.
inline int default_threads() {
  return omp_get_max_threads();
}

}  // namespace talus
