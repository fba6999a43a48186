// SPDX-License-Identifier: MIT
#pragma once
// Emulation of a GPU on the CPU, for tests: HostGrid runs the same kernels in loops, slowly and with the same results.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <new>
#include <numeric>
#include <vector>

#include "base/parallel.hpp"
#include "mpm/backend/device.hpp"

namespace talus::mpm {

struct Emulation {
  bool backwards = false;  ///< run threads in reverse order, which must not change the result
  int threads = 1;         ///< CPU threads, over which the blocks of a launch are distributed
  int block = 128;         ///< threads of a launch that run consecutively; 1: neighbouring threads never do
  std::size_t memory = 0;  ///< of the emulated device [bytes]; 0: no limit
  int launches = 0;        ///< the device is lost after this number of launches; 0: never
};

template <int D>
std::unique_ptr<Device<D>> make_emulated_device(const Emulation& how = {});

}  // namespace talus::mpm

namespace talus::mpm::device {

// HostGrid, the emulated grid. A grid allocates memory, launches kernels, and has three algorithms: sum, scan and sort.
// cuda/cuda_grid.hpp has the grid of a GPU.

/// Threads of a block.
inline constexpr int block_threads = 128;

class HostGrid {
 public:
  explicit HostGrid(const Emulation& how)
      : backwards_(how.backwards), threads_(how.threads), block_(how.block), launches_(how.launches) {
    room_ = how.memory > 0 ? how.memory : SIZE_MAX;
  }

  static void* allocate(std::size_t bytes) {
    const std::size_t whole = bytes + sizeof(std::max_align_t);
    if (whole > find_free()) throw std::bad_alloc();
    auto* start = static_cast<std::max_align_t*>(std::malloc(whole));
    if (start == nullptr) throw std::bad_alloc();
    std::memcpy(start, &whole, sizeof whole);
    used_ += whole;
    return start + 1;
  }
  static void release(void* p) {
    auto* start = static_cast<std::max_align_t*>(p) - 1;
    std::size_t whole = 0;
    std::memcpy(&whole, start, sizeof whole);
    used_ -= whole;
    std::free(start);
  }
  static DeviceMemory find_memory() { return {find_free(), room_}; }
  static void clear(void* p, std::size_t bytes) { std::memset(p, 0, bytes); }
  static void upload(void* device, const void* host, std::size_t bytes) { std::memcpy(device, host, bytes); }
  static void download(void* host, const void* device, std::size_t bytes) { std::memcpy(host, device, bytes); }

  static void wait() {}  ///< until all launches have finished

  /// Runs kernel(i) for all i below n.
  void launch(int n, const auto& kernel) {
    count_launch();
    const int blocks = (n + block_ - 1) / block_;
    const int workers = count_workers(blocks);
    parallel_for(workers, workers, [&](int worker) {
      for (int block = worker; block < blocks; block += workers) {
        for (int thread = 0; thread < block_; ++thread) {
          const int i = block * block_ + thread;
          if (i < n) kernel(backwards_ ? n - 1 - i : i);
        }
      }
    });
  }
  /// Sums summand(i) for all i below n in a fixed order, and writes the sum to device memory at `sum`.
  template <class S, class Summand>
  void sum(int n, const Summand& summand, S* sum) {
    count_launch();
    const int blocks = (n + block_threads - 1) / block_threads;
    std::vector<S> parts(static_cast<std::size_t>(blocks));
    parallel_for(blocks, count_workers(blocks), [&](int block) {
      const int end = std::min(n, (block + 1) * block_threads);
      for (int i = block * block_threads; i < end; ++i) parts[static_cast<std::size_t>(block)].add(summand(i));
    });
    *sum = S{};
    for (const S& part : parts) sum->add(part);
  }
  /// starts[i] = counts[0] + … + counts[i - 1] for all i below n.
  static void scan(const int* counts, int* starts, int n) { std::exclusive_scan(counts, counts + n, starts, 0); }
  /// Stable sort of the n `order`s by their keys; `sorted` receives the keys.
  static void sort(const unsigned* keys, unsigned* sorted, int* order, int n) {
    std::vector<int> by(static_cast<std::size_t>(n));
    std::iota(by.begin(), by.end(), 0);
    std::stable_sort(by.begin(), by.end(), [keys](int a, int b) { return keys[a] < keys[b]; });
    for (int i = 0; i < n; ++i) sorted[i] = keys[by[static_cast<std::size_t>(i)]];
    const std::vector<int> before(order, order + n);
    for (int i = 0; i < n; ++i) order[i] = before[static_cast<std::size_t>(by[static_cast<std::size_t>(i)])];
  }

 private:
  /// For few blocks, waiting for other threads costs more than it saves.
  int count_workers(int blocks) const { return blocks < 64 ? 1 : threads_; }
  void count_launch() {
    if (launches_ > 0 && --launches_ == 0) throw_lost("as it was told to");
  }
  static std::size_t find_free() { return room_ - std::min<std::size_t>(room_, used_); }

  /// Blocks and threads run from the last to the first; results must be bitwise identical.
  bool backwards_;
  int threads_, block_;
  int launches_;  ///< left until the device is lost
  // Memory of the one emulated device [bytes].
  static inline std::atomic<std::size_t> room_ = SIZE_MAX, used_ = 0;
};

}  // namespace talus::mpm::device
