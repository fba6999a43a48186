// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <variant>

/// Before a function that a GPU calls too.
#if defined(__CUDACC__)
#define TALUS_PORTABLE __host__ __device__
#else
#define TALUS_PORTABLE
#endif

namespace talus {

// Flags that several threads may raise together, here and on a GPU.

/// Several threads may raise a flag together, and others look at it meanwhile; which of them see it must not matter.
template <class Flag>
TALUS_PORTABLE void raise_flag(Flag& flag) {
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

// What a variant holds, where std::visit() is not to be had: on a GPU.

/// work() of what a variant holds, as std::visit() of one variant, which a GPU does not know. All kinds give the same
/// type.
template <std::size_t Kind = 0, class Work, class Variant>
TALUS_PORTABLE auto visit_kind(const Work& work, const Variant& variant) {
  if constexpr (Kind + 1 == std::variant_size_v<Variant>) {
    return work(*std::get_if<Kind>(&variant));
  } else {
    if (variant.index() == Kind) return work(*std::get_if<Kind>(&variant));
    return visit_kind<Kind + 1>(work, variant);
  }
}

}  // namespace talus
