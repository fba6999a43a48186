// SPDX-License-Identifier: MIT
#pragma once
// Transfer between node rows in memory and packs of elements: whole rows are loaded and transposed in registers, which
// is faster than one gather per component (docs/verification_data/speed.md).

#include <cstdint>

#include "base/lane.hpp"

namespace talus {

// Overload for a GPU thread: its element has one row per node, and no other thread adds to the sums of these rows.

template <int N, int Stride, int First = 0>
TALUS_KERNEL void load_rows(const double* base, const int* rows, double* out) {
  TALUS_UNROLL
  for (int c = 0; c < N; ++c) out[c] = base[static_cast<std::int64_t>(rows[0]) * Stride + First + c];
}

TALUS_KERNEL void store_four(double* to, const double* values) {
  TALUS_UNROLL
  for (int c = 0; c < 4; ++c) to[c] = values[c];
}

#if !defined(__CUDACC__)
namespace detail {

typedef double V8 __attribute__((vector_size(64)));

/// Transposes eight rows of eight doubles in place.
inline __attribute__((always_inline)) void transpose(V8* r) {
  V8 t[8], u[8];
  TALUS_UNROLL
  for (int i = 0; i < 4; ++i) {
    t[2 * i] = __builtin_shufflevector(r[2 * i], r[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    t[2 * i + 1] = __builtin_shufflevector(r[2 * i], r[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  TALUS_UNROLL
  for (int h = 0; h < 2; ++h) {
    TALUS_UNROLL
    for (int i = 0; i < 2; ++i) {
      const V8 a = t[4 * h + i], b = t[4 * h + 2 + i];
      u[4 * h + i] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
      u[4 * h + 2 + i] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  TALUS_UNROLL
  for (int i = 0; i < 4; ++i) {
    r[i] = __builtin_shufflevector(u[i], u[4 + i], 0, 1, 2, 3, 8, 9, 10, 11);
    r[4 + i] = __builtin_shufflevector(u[i], u[4 + i], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}

/// Transposes between four packs and the rows of four values of eight lanes, where a register holds the rows of lanes i
/// and i + 4; the same shuffles serve both directions.
inline __attribute__((always_inline)) void transpose_four(const V8* x, V8* y) {
  const V8 t0 = __builtin_shufflevector(x[0], x[1], 0, 8, 2, 10, 4, 12, 6, 14);
  const V8 t1 = __builtin_shufflevector(x[0], x[1], 1, 9, 3, 11, 5, 13, 7, 15);
  const V8 t2 = __builtin_shufflevector(x[2], x[3], 0, 8, 2, 10, 4, 12, 6, 14);
  const V8 t3 = __builtin_shufflevector(x[2], x[3], 1, 9, 3, 11, 5, 13, 7, 15);
  y[0] = __builtin_shufflevector(t0, t2, 0, 1, 8, 9, 4, 5, 12, 13);
  y[1] = __builtin_shufflevector(t1, t3, 0, 1, 8, 9, 4, 5, 12, 13);
  y[2] = __builtin_shufflevector(t0, t2, 2, 3, 10, 11, 6, 7, 14, 15);
  y[3] = __builtin_shufflevector(t1, t3, 2, 3, 10, 11, 6, 7, 14, 15);
}

#if defined(__AVX512DQ__)
/// Returns the row of a lane from those that transpose_four() returned. The zero-masked form avoids a warning of
/// GCC 12.
inline __attribute__((always_inline)) __m256d get_row(const V8* y, int lane) {
  const __m512d pair = static_cast<__m512d>(y[lane % 4]);
  return lane < 4 ? _mm512_maskz_extractf64x4_pd(0xff, pair, 0) : _mm512_maskz_extractf64x4_pd(0xff, pair, 1);
}
#endif

}  // namespace detail

/// Loads out[c] = base[rows[lane] * Stride + First + c], c < N. Rows are aligned to Stride doubles.
template <int N, int Stride, int First = 0>
inline __attribute__((always_inline)) void load_rows(const double* base, const int* rows, Pack* out) {
#if defined(__AVX512DQ__)
  using detail::V8;
  if constexpr (Stride == 4 || Stride == 8) {
    TALUS_UNROLL
    for (int four = First / 4; four <= (First + N - 1) / 4; ++four) {
      // Lanes i and i + 4 share a register; the upper one is inserted from memory, without the port of the shuffles.
      V8 x[4], y[4];
      TALUS_UNROLL
      for (int i = 0; i < 4; ++i) {
        const double* low = base + static_cast<std::int64_t>(rows[i]) * Stride + 4 * four;
        const double* high = base + static_cast<std::int64_t>(rows[i + 4]) * Stride + 4 * four;
        x[i] = static_cast<V8>(
            _mm512_maskz_insertf64x4(0xff, _mm512_castpd256_pd512(_mm256_load_pd(low)), _mm256_load_pd(high), 1));
      }
      detail::transpose_four(x, y);
      TALUS_UNROLL
      for (int i = 0; i < 4; ++i) {
        const int c = 4 * four + i - First;
        if (c >= 0 && c < N) out[c].value = reinterpret_cast<Pack::Vector&>(y[i]);
      }
    }
    return;
  } else if constexpr (Stride % 8 == 0) {
    TALUS_UNROLL
    for (int chunk = First / 8; chunk <= (First + N - 1) / 8; ++chunk) {
      V8 r[8];
      TALUS_UNROLL
      for (int l = 0; l < 8; ++l)
        r[l] = *reinterpret_cast<const V8*>(base + static_cast<std::int64_t>(rows[l]) * Stride + 8 * chunk);
      detail::transpose(r);
      TALUS_UNROLL
      for (int i = 0; i < 8; ++i) {
        const int c = 8 * chunk + i - First;
        if (c >= 0 && c < N) out[c].value = reinterpret_cast<Pack::Vector&>(r[i]);
      }
    }
    return;
  }
#endif
  for (int l = 0; l < lane_width; ++l) {
    TALUS_UNROLL
    for (int c = 0; c < N; ++c) out[c].value[l] = base[static_cast<std::int64_t>(rows[l]) * Stride + First + c];
  }
}

/// Stores base[rows[lane] * Stride + c] = values[c], c < N. The rest of a row of eight is zeroed.
template <int N, int Stride>
inline __attribute__((always_inline)) void store_rows(double* base, const int* rows, const Pack* values) {
#if defined(__AVX512DQ__)
  using detail::V8;
  const auto at = [&](int c) { return c < N ? reinterpret_cast<const V8&>(values[c].value) : V8{}; };
  if constexpr (N == 4 && Stride == 4) {
    const V8 columns[4] = {at(0), at(1), at(2), at(3)};
    V8 y[4];
    detail::transpose_four(columns, y);
    TALUS_UNROLL
    for (int l = 0; l < 8; ++l) {
      _mm256_store_pd(base + static_cast<std::int64_t>(rows[l]) * Stride, detail::get_row(y, l));
    }
    return;
  } else if constexpr (N <= 8 && Stride % 8 == 0) {
    V8 r[8];
    TALUS_UNROLL
    for (int c = 0; c < 8; ++c) r[c] = at(c);
    detail::transpose(r);
    TALUS_UNROLL
    for (int l = 0; l < 8; ++l) *reinterpret_cast<V8*>(base + static_cast<std::int64_t>(rows[l]) * Stride) = r[l];
    return;
  }
#endif
  for (int l = 0; l < lane_width; ++l) {
    TALUS_UNROLL
    for (int c = 0; c < N; ++c) base[static_cast<std::int64_t>(rows[l]) * Stride + c] = values[c].value[l];
  }
}

/// Stores lane_width consecutive rows of four doubles: to[lane * 4 + c] = values[c].
inline __attribute__((always_inline)) void store_four(double* to, const Pack* values) {
  if constexpr (lane_width == 8) {
    using detail::V8;
    const auto at = [&](int c) { return reinterpret_cast<const V8&>(values[c].value); };
    const V8 t0 = __builtin_shufflevector(at(0), at(1), 0, 8, 2, 10, 4, 12, 6, 14);
    const V8 t1 = __builtin_shufflevector(at(0), at(1), 1, 9, 3, 11, 5, 13, 7, 15);
    const V8 t2 = __builtin_shufflevector(at(2), at(3), 0, 8, 2, 10, 4, 12, 6, 14);
    const V8 t3 = __builtin_shufflevector(at(2), at(3), 1, 9, 3, 11, 5, 13, 7, 15);
    const V8 y0 = __builtin_shufflevector(t0, t2, 0, 1, 8, 9, 4, 5, 12, 13);
    const V8 y1 = __builtin_shufflevector(t1, t3, 0, 1, 8, 9, 4, 5, 12, 13);
    const V8 y2 = __builtin_shufflevector(t0, t2, 2, 3, 10, 11, 6, 7, 14, 15);
    const V8 y3 = __builtin_shufflevector(t1, t3, 2, 3, 10, 11, 6, 7, 14, 15);
    V8* rows = reinterpret_cast<V8*>(to);
    rows[0] = __builtin_shufflevector(y0, y1, 0, 1, 2, 3, 8, 9, 10, 11);
    rows[1] = __builtin_shufflevector(y2, y3, 0, 1, 2, 3, 8, 9, 10, 11);
    rows[2] = __builtin_shufflevector(y0, y1, 4, 5, 6, 7, 12, 13, 14, 15);
    rows[3] = __builtin_shufflevector(y2, y3, 4, 5, 6, 7, 12, 13, 14, 15);
  } else {
    for (int l = 0; l < lane_width; ++l)
      for (int c = 0; c < 4; ++c) to[4 * l + c] = values[c].value[l];
  }
}

/// Adds base[rows[lane] * Stride + First + c] += values[c], in the order of the lanes.
template <int N, int First = 0, int Stride = 8>
inline __attribute__((always_inline)) void add_rows(double* base, const int* rows, const Pack* values) {
#if defined(__AVX512DQ__)
  using detail::V8;
  const auto at = [&](int c) {
    return c >= First && c < First + N ? reinterpret_cast<const V8&>(values[c - First].value) : V8{};
  };
  if constexpr (First / 4 == (First + N - 1) / 4) {
    constexpr int four = First / 4 * 4;
    const V8 columns[4] = {at(four), at(four + 1), at(four + 2), at(four + 3)};
    V8 y[4];
    detail::transpose_four(columns, y);
    TALUS_UNROLL
    for (int l = 0; l < 8; ++l) {
      double* row = base + static_cast<std::int64_t>(rows[l]) * Stride + four;
      _mm256_store_pd(row, _mm256_add_pd(_mm256_load_pd(row), detail::get_row(y, l)));
    }
  } else {
    TALUS_UNROLL
    for (int chunk = First / 8; chunk <= (First + N - 1) / 8; ++chunk) {
      V8 r[8];
      TALUS_UNROLL
      for (int c = 0; c < 8; ++c) r[c] = at(8 * chunk + c);
      detail::transpose(r);
      TALUS_UNROLL
      for (int l = 0; l < 8; ++l)
        *reinterpret_cast<V8*>(base + static_cast<std::int64_t>(rows[l]) * Stride + 8 * chunk) += r[l];
    }
  }
#else
  for (int l = 0; l < lane_width; ++l) {
    TALUS_UNROLL
    for (int c = 0; c < N; ++c) base[static_cast<std::int64_t>(rows[l]) * Stride + First + c] += values[c].value[l];
  }
#endif
}

#endif

}  // namespace talus
