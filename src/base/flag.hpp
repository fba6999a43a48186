// SPDX-License-Identifier: MIT
#pragma once
// Flags that several threads may raise together, here and on a GPU.

#include "base/portable.hpp"

namespace talus {

/// Several threads may raise a flag together, and others look at it meanwhile; which of them see it must not matter.
template <class Flag>
TALUS_PORTABLE void raise(Flag& flag) {
#ifdef __CUDA_ARCH__
  flag = 1;
#else
  __atomic_store_n(&flag, Flag{1}, __ATOMIC_RELAXED);
#endif
}
template <class Flag>
TALUS_PORTABLE bool is_raised(const Flag& flag) {
#ifdef __CUDA_ARCH__
  return flag != 0;
#else
  return __atomic_load_n(&flag, __ATOMIC_RELAXED) != 0;
#endif
}

}  // namespace talus
