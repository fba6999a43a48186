// SPDX-License-Identifier: MIT
#pragma once
// Helpers for code that is compiled for the CPU and for a GPU: the function attribute, flags that several threads may
// raise, and a visitor of variants.

#include <cstddef>
#include <variant>

/// Marks a function that is also compiled for a GPU.
#if defined(__CUDACC__)
#define TALUS_PORTABLE __host__ __device__
#else
#define TALUS_PORTABLE
#endif

namespace talus {

// Flags that several threads may raise concurrently, on the CPU and on a GPU.

/// Raises a flag. Other threads may read it concurrently; results must not depend on which of them already see it.
template <class Flag>
TALUS_PORTABLE void raise_flag(Flag& flag) {
#ifdef __CUDA_ARCH__
  flag = 1;
#else
  __atomic_store_n(&flag, Flag{1}, __ATOMIC_RELAXED);
#endif
}
TALUS_PORTABLE bool is_raised(const auto& flag) {
#ifdef __CUDA_ARCH__
  return flag != 0;
#else
  return __atomic_load_n(&flag, __ATOMIC_RELAXED) != 0;
#endif
}

/// Returns work() of the active alternative of a variant, in place of std::visit(), which is not available on a GPU.
/// The return type must be the same for all alternatives.
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
