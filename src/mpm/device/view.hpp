// SPDX-License-Identifier: MIT
#pragma once
// How the threads of a GPU see arrays.

#include <cstddef>

#include "base/portable.hpp"

namespace talus::mpm {

/// Elements of a block on a device, and rows of a slice of a matrix: the threads of a warp.
inline constexpr int device_width = 32;

/// Where something is stored, and for how many; the memory is someone else's.
template <class T>
struct View {
  T* start = nullptr;
  std::size_t count = 0;

  TALUS_PORTABLE T* data() const { return start; }
  TALUS_PORTABLE std::size_t size() const { return count; }
  TALUS_PORTABLE bool empty() const { return count == 0; }
  TALUS_PORTABLE T& operator[](std::size_t i) const { return start[i]; }
  /// From the lane on that is a thread's.
  TALUS_PORTABLE void shift(int lane) { start += lane; }
};

/// A pointer that is its own target.
template <class T>
struct Inside : T {
  TALUS_PORTABLE const T* operator->() const { return this; }
  TALUS_PORTABLE const T& operator*() const { return *this; }
};

}  // namespace talus::mpm
