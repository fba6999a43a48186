// SPDX-License-Identifier: MIT
#pragma once
// One kernel source for the CPU's vectors and for a GPU's threads: kernels are templates on T, which is either
// Pack (lane_width doubles, one element of the mesh per lane) or the plain double of one thread. This file is the only
// place that knows the instruction set. std::experimental::simd is not used: under clang with AVX-512 its masked
// assignment was silently wrong (docs/decisions/0004).

#include <cmath>
#include <cstdint>

#include "base/portable.hpp"

#if !defined(__CUDACC__) && (defined(__AVX512F__) || defined(__AVX2__))
#include <immintrin.h>
#endif

#if defined(__SANITIZE_ADDRESS__)  // such loops are not unrolled
#define TALUS_KERNEL inline __attribute__((always_inline))
#define TALUS_UNROLL
#elif defined(__CUDACC__)
#define TALUS_KERNEL __host__ __device__ __forceinline__
#define TALUS_UNROLL _Pragma("unroll")
#elif defined(__clang__)
#define TALUS_KERNEL inline __attribute__((always_inline))
#define TALUS_UNROLL _Pragma("clang loop unroll(full)")
#else
#define TALUS_KERNEL inline __attribute__((always_inline))
#define TALUS_UNROLL _Pragma("GCC unroll 16")
#endif

namespace talus {

/// The level of the instruction set that this code was compiled for, by its name in the x86-64 psABI; "aarch64" for
/// 64-bit ARM.
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__AVX512CD__) && defined(__AVX512DQ__) && \
    defined(__AVX512VL__)
inline constexpr const char* instruction_level = "x86-64-v4";
#elif defined(__AVX2__) && defined(__FMA__)
inline constexpr const char* instruction_level = "x86-64-v3";
#elif defined(__SSE4_2__)
inline constexpr const char* instruction_level = "x86-64-v2";
#elif defined(__aarch64__)
inline constexpr const char* instruction_level = "aarch64";
#else
inline constexpr const char* instruction_level = "basic";
#endif

#if defined(__AVX512F__)
inline constexpr int lane_width = 8;
#elif defined(__AVX__)
inline constexpr int lane_width = 4;
#else
inline constexpr int lane_width = 2;
#endif

#if defined(__CUDACC__)  // nvcc knows no vector types
struct Pack;
#else
/// One truth value per lane.
struct Mask {
  typedef std::int64_t Vector __attribute__((vector_size(8 * lane_width)));
  Vector bits;  ///< -1 where true, 0 where false

  Mask() = default;
  TALUS_KERNEL Mask(Vector b) : bits(b) {}
  TALUS_KERNEL explicit Mask(bool b) : bits(Vector{} - static_cast<std::int64_t>(b)) {}
  TALUS_KERNEL friend Mask operator&&(Mask a, Mask b) { return a.bits & b.bits; }
  TALUS_KERNEL friend Mask operator||(Mask a, Mask b) { return a.bits | b.bits; }
  TALUS_KERNEL Mask operator!() const { return ~bits; }
  TALUS_KERNEL bool operator[](int lane) const { return bits[lane] != 0; }
};

/// lane_width doubles, used like one.
struct Pack {
  typedef double Vector __attribute__((vector_size(8 * lane_width)));
  Vector value;

  Pack() = default;
  TALUS_KERNEL Pack(Vector v) : value(v) {}
  TALUS_KERNEL Pack(double s) : value(Vector{} + s) {}
  TALUS_KERNEL double operator[](int lane) const { return value[lane]; }

  TALUS_KERNEL friend Pack operator+(Pack a, Pack b) { return a.value + b.value; }
  TALUS_KERNEL friend Pack operator-(Pack a, Pack b) { return a.value - b.value; }
  TALUS_KERNEL friend Pack operator*(Pack a, Pack b) { return a.value * b.value; }
  TALUS_KERNEL friend Pack operator/(Pack a, Pack b) { return a.value / b.value; }
  TALUS_KERNEL Pack operator-() const { return -value; }
  TALUS_KERNEL Pack& operator+=(Pack b) {
    value += b.value;
    return *this;
  }
  TALUS_KERNEL Pack& operator-=(Pack b) {
    value -= b.value;
    return *this;
  }
  TALUS_KERNEL Pack& operator*=(Pack b) {
    value *= b.value;
    return *this;
  }
  TALUS_KERNEL friend Mask operator<(Pack a, Pack b) { return Mask(static_cast<Mask::Vector>(a.value < b.value)); }
  TALUS_KERNEL friend Mask operator>(Pack a, Pack b) { return Mask(static_cast<Mask::Vector>(a.value > b.value)); }
  TALUS_KERNEL friend Mask operator==(Pack a, Pack b) { return Mask(static_cast<Mask::Vector>(a.value == b.value)); }
};

#endif

/// Width and mask type of a lane type.
template <class T>
struct LaneTraits;
template <>
struct LaneTraits<double> {
  using mask = bool;
  static constexpr int width = 1;
};
#if !defined(__CUDACC__)
template <>
struct LaneTraits<Pack> {
  using mask = Mask;
  static constexpr int width = lane_width;
};
#endif
template <class T>
using MaskOf = typename LaneTraits<T>::mask;

// Selection, comparison and reduction, for a double and for a Pack ------------------------------------------------

TALUS_KERNEL double select(bool c, double a, double b) {
  return c ? a : b;
}
TALUS_KERNEL double lane_max(double a, double b) {
  return a > b ? a : b;
}
TALUS_KERNEL double lane_min(double a, double b) {
  return a < b ? a : b;
}
TALUS_KERNEL double lane_abs(double a) {
  return a < 0 ? -a : a;
}
TALUS_KERNEL double lane_sqrt(double a) {
  return std::sqrt(a);
}
TALUS_KERNEL bool any(bool m) {
  return m;
}
TALUS_KERNEL bool all(bool m) {
  return m;
}
/// One bit per lane, lane 0 lowest.
TALUS_KERNEL unsigned to_bits(bool m) {
  return m ? 1 : 0;
}
TALUS_KERNEL double sum_lanes(double a) {
  return a;
}
TALUS_KERNEL void set_lane(double& a, int /*lane*/, double value) {
  a = value;
}
TALUS_KERNEL void store(double* p, double a) {
  *p = a;
}

#if !defined(__CUDACC__)
TALUS_KERNEL Pack select(Mask c, Pack a, Pack b) {
  return c.bits ? a.value : b.value;
}
TALUS_KERNEL Pack lane_max(Pack a, Pack b) {
  return a.value > b.value ? a.value : b.value;
}
TALUS_KERNEL Pack lane_min(Pack a, Pack b) {
  return a.value < b.value ? a.value : b.value;
}
TALUS_KERNEL Pack lane_abs(Pack a) {
  return a.value < 0 ? -a.value : a.value;
}
TALUS_KERNEL Pack lane_sqrt(Pack a) {
#if defined(__AVX512F__)
  // the zero-masked form: GCC 12 warns of an uninitialised value inside the plain one
  return static_cast<Pack::Vector>(_mm512_maskz_sqrt_pd(0xff, static_cast<__m512d>(a.value)));
#elif defined(__AVX__)
  return static_cast<Pack::Vector>(_mm256_sqrt_pd(static_cast<__m256d>(a.value)));
#else
  Pack r;
  for (int l = 0; l < lane_width; ++l) r.value[l] = std::sqrt(a.value[l]);
  return r;
#endif
}

TALUS_KERNEL double sum_lanes(Pack a) {
  double sum = 0;
  for (int l = 0; l < lane_width; ++l) sum += a.value[l];
  return sum;
}
TALUS_KERNEL void set_lane(Pack& a, int lane, double value) {
  a.value[lane] = value;
}

TALUS_KERNEL unsigned to_bits(Mask m) {
#if defined(__AVX512DQ__)
  return _mm512_movepi64_mask(reinterpret_cast<__m512i>(m.bits));
#elif defined(__AVX512F__)
  return _mm512_test_epi64_mask(reinterpret_cast<__m512i>(m.bits), reinterpret_cast<__m512i>(m.bits));
#elif defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(m.bits)));
#else
  unsigned r = 0;
  for (int l = 0; l < lane_width; ++l) r |= static_cast<unsigned>(m.bits[l] != 0) << l;
  return r;
#endif
}
TALUS_KERNEL bool any(Mask m) {
  return to_bits(m) != 0;
}
TALUS_KERNEL bool all(Mask m) {
  return to_bits(m) == (1u << lane_width) - 1;
}

TALUS_KERNEL void store(double* p, Pack a) {
  *reinterpret_cast<Pack::Vector*>(p) = a.value;
}
#endif

/// Loads a pack from memory that is aligned to it, or the double of a thread.
template <class T>
TALUS_KERNEL T load(const double* p) {
  if constexpr (LaneTraits<T>::width == 1)
    return *p;
  else
    return T(*reinterpret_cast<const typename T::Vector*>(p));
}

}  // namespace talus
