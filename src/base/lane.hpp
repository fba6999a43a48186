// SPDX-License-Identifier: MIT
#pragma once
// One kernel source for SIMD on the CPU and threads on a GPU: kernels are templates on T, either Pack (lane_width
// doubles, one element of the mesh per lane) or the double of one thread. Only this file and rows.hpp depend on the
// instruction set. std::experimental::simd is not used: under clang with AVX-512 its masked assignment gave wrong
// results silently (docs/decisions/0004).

#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>

#include "base/portable.hpp"

#if !defined(__CUDACC__) && (defined(__AVX512F__) || defined(__AVX2__))
#include <immintrin.h>
#endif

#if defined(__SANITIZE_ADDRESS__)  // the address sanitizer prevents unrolling
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

/// The instruction-set level of this build by its name in the x86-64 psABI; "aarch64" for 64-bit ARM.
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

#if defined(__CUDACC__)  // nvcc has no vector types
struct Pack;
#else
namespace detail {
typedef double Doubles __attribute__((vector_size(8 * lane_width)));
typedef std::int64_t Integers __attribute__((vector_size(8 * lane_width)));
}  // namespace detail

#if defined(__AVX512DQ__)
/// One Boolean per lane, in a mask register. The operators are intrinsics, because GCC moves the operands of plain ones
/// to general registers and back.
struct Mask {
  __mmask8 bits;  ///< one bit per lane, lane 0 lowest

  Mask() = default;
  template <std::same_as<__mmask8> Bits>  // not a bool
  TALUS_KERNEL Mask(Bits b) : bits(b) {}
  TALUS_KERNEL explicit Mask(bool b) : bits(b ? 0xff : 0) {}
  TALUS_KERNEL friend Mask operator&&(Mask a, Mask b) { return _kand_mask8(a.bits, b.bits); }
  TALUS_KERNEL friend Mask operator||(Mask a, Mask b) { return _kor_mask8(a.bits, b.bits); }
  TALUS_KERNEL Mask operator!() const { return _knot_mask8(bits); }
  TALUS_KERNEL bool operator[](int lane) const { return (bits >> lane & 1) != 0; }
};

namespace detail {
TALUS_KERNEL Doubles broadcast(double s) {
  return static_cast<Doubles>(_mm512_set1_pd(s));
}
TALUS_KERNEL Mask is_less(Doubles a, Doubles b) {
  return _mm512_cmp_pd_mask(static_cast<__m512d>(a), static_cast<__m512d>(b), _CMP_LT_OQ);
}
TALUS_KERNEL Mask is_equal(Doubles a, Doubles b) {
  return _mm512_cmp_pd_mask(static_cast<__m512d>(a), static_cast<__m512d>(b), _CMP_EQ_OQ);
}
TALUS_KERNEL Doubles select(Mask c, Doubles a, Doubles b) {
  return static_cast<Doubles>(_mm512_mask_blend_pd(c.bits, static_cast<__m512d>(b), static_cast<__m512d>(a)));
}
}  // namespace detail
#else
/// One Boolean per lane.
struct Mask {
  detail::Integers bits;  ///< -1 where true, 0 where false

  Mask() = default;
  TALUS_KERNEL Mask(detail::Integers b) : bits(b) {}
  TALUS_KERNEL explicit Mask(bool b) : bits(detail::Integers{} - static_cast<std::int64_t>(b)) {}
  TALUS_KERNEL friend Mask operator&&(Mask a, Mask b) { return a.bits & b.bits; }
  TALUS_KERNEL friend Mask operator||(Mask a, Mask b) { return a.bits | b.bits; }
  TALUS_KERNEL Mask operator!() const { return ~bits; }
  TALUS_KERNEL bool operator[](int lane) const { return bits[lane] != 0; }
};

namespace detail {
TALUS_KERNEL Doubles broadcast(double s) {
  return Doubles{} + s;
}
TALUS_KERNEL Mask is_less(Doubles a, Doubles b) {
  return static_cast<Integers>(a < b);
}
TALUS_KERNEL Mask is_equal(Doubles a, Doubles b) {
  return static_cast<Integers>(a == b);
}
TALUS_KERNEL Doubles select(Mask c, Doubles a, Doubles b) {
  return c.bits ? a : b;
}
}  // namespace detail
#endif

/// lane_width doubles with the operators of a double.
struct Pack {
  using Vector = detail::Doubles;
  Vector value;

  Pack() = default;
  TALUS_KERNEL Pack(Vector v) : value(v) {}
  TALUS_KERNEL Pack(double s) : value(detail::broadcast(s)) {}
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
  TALUS_KERNEL friend Mask operator<(Pack a, Pack b) { return detail::is_less(a.value, b.value); }
  TALUS_KERNEL friend Mask operator>(Pack a, Pack b) { return detail::is_less(b.value, a.value); }
  TALUS_KERNEL friend Mask operator==(Pack a, Pack b) { return detail::is_equal(a.value, b.value); }
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
/// Returns one bit per lane, lane 0 lowest.
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
  return detail::select(c, a.value, b.value);
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
  // The zero-masked form avoids a warning of GCC 12 about an uninitialised value in the unmasked one.
  return static_cast<Pack::Vector>(_mm512_maskz_sqrt_pd(0xff, static_cast<__m512d>(a.value)));
#elif defined(__AVX__)
  return static_cast<Pack::Vector>(_mm256_sqrt_pd(static_cast<__m256d>(a.value)));
#else
  Pack r;
  for (int l = 0; l < lane_width; ++l) r.value[l] = std::sqrt(a.value[l]);
  return r;
#endif
}

/// Returns `a`. The compiler does not fuse a product that is rounded so with a later sum.
TALUS_KERNEL Pack round_lanes(Pack a) {
#if defined(__x86_64__)
  __asm__("" : "+v"(a.value));
#elif defined(__aarch64__)
  __asm__("" : "+w"(a.value));
#endif
  return a;
}
TALUS_KERNEL double sum_lanes(Pack a) {
  double sum = 0;
  for (int l = 0; l < lane_width; ++l) sum += a.value[l];
  return sum;
}
TALUS_KERNEL void set_lane(Pack& a, int lane, double value) {
  a.value[lane] = value;
}

TALUS_KERNEL void set_lane(Mask& m, int lane, bool value) {
#if defined(__AVX512DQ__)
  m.bits = static_cast<__mmask8>((m.bits & ~(1u << lane)) | static_cast<unsigned>(value) << lane);
#else
  m.bits[lane] = value ? -1 : 0;
#endif
}
TALUS_KERNEL unsigned to_bits(Mask m) {
#if defined(__AVX512DQ__)
  return m.bits;
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

/// Loads a pack from memory aligned to its size, or the double of a thread.
template <class T>
TALUS_KERNEL T load(const double* p) {
  if constexpr (LaneTraits<T>::width == 1)
    return *p;
  else
    return T(*reinterpret_cast<const typename T::Vector*>(p));
}

/// Loads lane_width doubles from memory of any alignment, or the double of a thread.
template <class T>
TALUS_KERNEL T load_unaligned(const double* p) {
  T value;
  std::memcpy(&value, p, sizeof value);
  return value;
}
template <class T>
TALUS_KERNEL void store_unaligned(double* p, const T& value) {
  std::memcpy(p, &value, sizeof value);
}

/// Loads base[index[lane]] into each lane.
template <class T>
TALUS_KERNEL T gather(const double* base, const int* index) {
  if constexpr (LaneTraits<T>::width == 1) {
    return base[*index];
  } else {
#if defined(__AVX512F__) && !defined(__CUDACC__)
    const __m256i places = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
    return T(static_cast<typename T::Vector>(_mm512_mask_i32gather_pd(_mm512_setzero_pd(), 0xff, places, base, 8)));
#else
    T value;
    for (int l = 0; l < LaneTraits<T>::width; ++l) value.value[l] = base[index[l]];
    return value;
#endif
  }
}

/// Returns whether base[index[lane]] is negative in all lanes.
template <class T>
TALUS_KERNEL bool are_negative(const int* base, const int* index) {
#if defined(__AVX512F__) && !defined(__CUDACC__)
  if constexpr (LaneTraits<T>::width == 8) {
    const __m256i places = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(index));
    return _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_i32gather_epi32(base, places, 4))) == 0xff;
  }
#endif
  for (int l = 0; l < LaneTraits<T>::width; ++l)
    if (base[index[l]] >= 0) return false;
  return true;
}

/// Returns in which lanes p[lane] is above a limit.
template <class T>
TALUS_KERNEL MaskOf<T> are_above(const int* p, int limit) {
  if constexpr (LaneTraits<T>::width == 1) {
    return *p > limit;
  } else {
#if !defined(__CUDACC__)
    typedef int Ints __attribute__((vector_size(4 * lane_width)));
    Ints values;
    std::memcpy(&values, p, sizeof values);
    return T(__builtin_convertvector(values, typename T::Vector)) > T(static_cast<double>(limit));
#endif
  }
}

}  // namespace talus

namespace talus {

// Logarithm, exponential and power for a double and for a Pack, which the laws of soil water evaluate in every lane. A
// lane and a double give bitwise identical results. Errors: 2 ulp for log and exp; |y ln x| ulp in addition for a
// power.

namespace detail {

/// Reinterprets a double as an integer, and back.
TALUS_KERNEL std::int64_t to_integer(double a) {
  std::int64_t r;
  std::memcpy(&r, &a, sizeof r);
  return r;
}
TALUS_KERNEL double to_lanes(std::int64_t a) {
  double r;
  std::memcpy(&r, &a, sizeof r);
  return r;
}
#if !defined(__CUDACC__)
TALUS_KERNEL Integers to_integer(Pack a) {
  return reinterpret_cast<Integers>(a.value);
}
TALUS_KERNEL Pack to_lanes(Integers a) {
  return reinterpret_cast<Pack::Vector>(a);
}
#endif

inline constexpr double ln2_high = 0x1.62e42fefa38p-1;  ///< truncated, so that its product with an exponent is exact
inline constexpr double ln2_low = 0x1.ef35793c7673p-45;
inline constexpr double round_shift = 0x1.8p52;  ///< after adding it, the low bits are the nearest integer

/// Evaluates Σ c_i x^i by Estrin's scheme, whose dependency chain is short.
template <std::size_t N, class T>
TALUS_KERNEL T find_polynomial(const double (&c)[N], T x) {
  T sum[(N + 1) / 2];
  TALUS_UNROLL
  for (std::size_t i = 0; i < N / 2; ++i) sum[i] = c[2 * i] + c[2 * i + 1] * x;
  if (N % 2 == 1) sum[N / 2] = T(c[N - 1]);
  std::size_t count = (N + 1) / 2;
  TALUS_UNROLL
  for (int level = 0; level < 4; ++level) {
    x = x * x;
    TALUS_UNROLL
    for (std::size_t i = 0; i < count / 2; ++i) sum[i] = sum[2 * i] + sum[2 * i + 1] * x;
    if (count % 2 == 1 && count > 1) sum[count / 2] = sum[count - 1];
    count = (count + 1) / 2;
  }
  return sum[0];
}

}  // namespace detail

/// Returns the natural logarithm of a positive normal number; undefined for other arguments.
template <class T>
TALUS_KERNEL T lane_log(T x) {
  constexpr double artanh[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                               2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
  constexpr std::int64_t root_half = 0x3FE6A09E667F3BCD, shift_bits = 0x4338000000000000;
  const auto exponent = (detail::to_integer(x) - root_half) >> 52;
  const T m = detail::to_lanes(detail::to_integer(x) - (exponent << 52));  // in [√½, √2)
  const T k = detail::to_lanes(exponent + shift_bits) - detail::round_shift;
  const T s = (m - 1.0) / (m + 1.0), z = s * s;  // ln m = 2 artanh s
  return k * detail::ln2_high + (2.0 * s + (s * z * detail::find_polynomial(artanh, z) + k * detail::ln2_low));
}

/// Returns the exponential; the argument is limited to [-708, 709].
template <class T>
TALUS_KERNEL T lane_exp(T x) {
  constexpr double inverse_factorial[] = {
      1.0,        1.0,         0.5,          1.0 / 6,       1.0 / 24,       1.0 / 120,       1.0 / 720,
      1.0 / 5040, 1.0 / 40320, 1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  x = lane_max(T(-708.0), lane_min(T(709.0), x));
  const T shifted = x * 1.4426950408889634 + detail::round_shift;
  const T k = shifted - detail::round_shift;
  const T r = (x - k * detail::ln2_high) - k * detail::ln2_low;  // |r| <= ln 2 / 2
  const T p = detail::find_polynomial(inverse_factorial, r);
  const auto whole = detail::to_integer(shifted) - detail::to_integer(detail::round_shift);
  return p * detail::to_lanes((whole + 1023) << 52);
}

/// Returns x^y for positive x.
template <class T>
TALUS_KERNEL T lane_power(T x, double y) {
  return lane_exp(lane_log(x) * y);
}

}  // namespace talus
