// SPDX-License-Identifier: MIT
#pragma once
// The CPU in the place of a GPU: the grid and its blocks are loops. With it the kernels are tested where no GPU is. A
// grid has memory, launches kernels, and knows two algorithms; cuda/cuda_grid.hpp is the other one.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <numeric>
#include <vector>

namespace talus::mpm::device {

/// Threads of a block.
inline constexpr int block_threads = 128;

struct HostGrid {
  /// Blocks and threads from the last to the first: the results must be the same bits.
  bool backwards = false;

  static void* allocate(std::size_t bytes) {
    void* p = std::malloc(std::max<std::size_t>(bytes, 1));
    if (p == nullptr) throw std::bad_alloc();
    return p;
  }
  static void release(void* p) { std::free(p); }
  static void clear(void* p, std::size_t bytes) { std::memset(p, 0, bytes); }
  static void bring(void* device, const void* host, std::size_t bytes) { std::memcpy(device, host, bytes); }
  static void fetch(void* host, const void* device, std::size_t bytes) { std::memcpy(host, device, bytes); }

  /// Runs kernel(i) for all i below n.
  template <class Kernel>
  void launch(int n, const Kernel& kernel) const {
    const int blocks = (n + block_threads - 1) / block_threads;
    for (int block = 0; block < blocks; ++block) {
      for (int thread = 0; thread < block_threads; ++thread) {
        const int i = (backwards ? blocks - 1 - block : block) * block_threads +
                      (backwards ? block_threads - 1 - thread : thread);
        if (i < n) kernel(i);
      }
    }
  }
  /// starts[i] = counts[0] + … + counts[i - 1]; returns the sum of all n.
  static int scan(const int* counts, int* starts, int n) {
    int sum = 0;
    for (int i = 0; i < n; ++i) {
      starts[i] = sum;
      sum += counts[i];
    }
    return sum;
  }
  /// Sorts the n `order`s by their keys, those of equal ones as they were; `sorted`: the keys.
  static void sort(const unsigned* keys, unsigned* sorted, int* order, int n) {
    std::vector<int> by(static_cast<std::size_t>(n));
    std::iota(by.begin(), by.end(), 0);
    std::stable_sort(by.begin(), by.end(), [keys](int a, int b) { return keys[a] < keys[b]; });
    for (int i = 0; i < n; ++i) sorted[i] = keys[by[static_cast<std::size_t>(i)]];
    const std::vector<int> before(order, order + n);
    for (int i = 0; i < n; ++i) order[i] = before[static_cast<std::size_t>(by[static_cast<std::size_t>(i)])];
  }
};

}  // namespace talus::mpm::device
