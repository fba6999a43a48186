// SPDX-License-Identifier: MIT
#pragma once
// A GPU as a grid (interface: HostGrid in mpm/backend/emulated.hpp). All operations run in order in one stream.

#include <thrust/iterator/counting_iterator.h>
#include <cub/cub.cuh>

#include <new>
#include <string>
#include <utility>

#include "mpm/backend/device.hpp"
#include "mpm/backend/emulated.hpp"

namespace talus::mpm::device {

/// Throws if a CUDA call failed: std::bad_alloc when memory ran out.
inline void require(cudaError_t code) {
  if (code == cudaSuccess) return;
  cudaGetLastError();  // otherwise the next launch would report it again
  if (code == cudaErrorMemoryAllocation) throw std::bad_alloc();
  throw_lost(cudaGetErrorString(code));
}

template <class Kernel>
__global__ void run_kernel(Kernel kernel, int n) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < n) kernel(i);
}

/// Sum of two objects by their add().
template <class S>
struct Add {
  __host__ __device__ S operator()(const S& a, const S& b) const {
    S sum = a;
    sum.add(b);
    return sum;
  }
};

class CudaGrid {
 public:
  CudaGrid() = default;
  CudaGrid(CudaGrid&& other) noexcept : scratch_(std::exchange(other.scratch_, nullptr)), room_(other.room_) {}
  ~CudaGrid() { cudaFree(scratch_); }

  static DeviceMemory find_memory() {
    DeviceMemory memory;
    require(cudaMemGetInfo(&memory.free, &memory.total));
    return memory;
  }
  static void* allocate(std::size_t bytes) {
    void* p = nullptr;
    require(cudaMalloc(&p, bytes));
    return p;
  }
  static void release(void* p) { cudaFree(p); }
  static void clear(void* p, std::size_t bytes) { require(cudaMemsetAsync(p, 0, bytes)); }
  static void upload(void* device, const void* host, std::size_t bytes) {
    require(cudaMemcpy(device, host, bytes, cudaMemcpyHostToDevice));
  }
  static void download(void* host, const void* device, std::size_t bytes) {
    require(cudaMemcpy(host, device, bytes, cudaMemcpyDeviceToHost));
  }

  static void wait() { require(cudaDeviceSynchronize()); }

  template <class Kernel>
  void launch(int n, const Kernel& kernel) const {
    run_kernel<<<(n + block_threads - 1) / block_threads, block_threads>>>(kernel, n);
    require(cudaGetLastError());
  }
  /// CUB guarantees the same order of summation from run to run on one kind of device.
  template <class S, class Summand>
  void sum(int n, const Summand& summand, S* sum) {
    const thrust::counting_iterator<int> first(0);
    std::size_t bytes = 0;
    require(cub::DeviceReduce::TransformReduce(nullptr, bytes, first, sum, n, Add<S>{}, summand, S{}));
    require(cub::DeviceReduce::TransformReduce(find_room(bytes), bytes, first, sum, n, Add<S>{}, summand, S{}));
  }
  void scan(const int* counts, int* starts, int n) {
    std::size_t bytes = 0;
    require(cub::DeviceScan::ExclusiveSum(nullptr, bytes, counts, starts, n));
    require(cub::DeviceScan::ExclusiveSum(find_room(bytes), bytes, counts, starts, n));
  }
  void sort(const unsigned* keys, unsigned* sorted, int* order, int n) {
    const std::size_t list = sizeof(int) * static_cast<std::size_t>(n);
    std::size_t bytes = 0;
    require(cub::DeviceRadixSort::SortPairs(nullptr, bytes, keys, sorted, order, order, n));
    const std::size_t before = (bytes + 255) / 256 * 256;
    char* room = static_cast<char*>(find_room(before + list));
    int* unsorted = reinterpret_cast<int*>(room + before);
    require(cudaMemcpyAsync(unsorted, order, list, cudaMemcpyDeviceToDevice));
    require(cub::DeviceRadixSort::SortPairs(room, bytes, keys, sorted, unsorted, order, n));
  }

 private:
  void* find_room(std::size_t bytes) {
    if (bytes > room_) {
      require(cudaFree(std::exchange(scratch_, nullptr)));
      room_ = 0;
      scratch_ = allocate(bytes);
      room_ = bytes;
    }
    return scratch_;
  }

  void* scratch_ = nullptr;
  std::size_t room_ = 0;
};

}  // namespace talus::mpm::device
