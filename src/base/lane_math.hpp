// SPDX-License-Identifier: MIT
#pragma once
// Logarithm, exponential and power for a double and for a Pack: the laws of soil water need them in every lane. Both
// are the same arithmetic, so a lane gives what a double gives. Errors: 2 units in the last place of log and exp; a
// power adds |y ln x| of them.

#include <cstring>

#include "base/lane.hpp"

namespace talus {

namespace detail {

/// The bits of a double as an integer, and back.
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
TALUS_KERNEL Mask::Vector to_integer(Pack a) {
  return reinterpret_cast<Mask::Vector>(a.value);
}
TALUS_KERNEL Pack to_lanes(Mask::Vector a) {
  return reinterpret_cast<Pack::Vector>(a);
}
#endif

inline constexpr double ln2_high = 0x1.62e42fefa38p-1;  ///< short, so that its product with an exponent is exact
inline constexpr double ln2_low = 0x1.ef35793c7673p-45;
inline constexpr double round_shift = 0x1.8p52;  ///< adding it leaves the nearest integer in the low bits

/// Σ c_i x^i by Estrin's scheme: a short chain of dependent operations, so that a core works on several at once.
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

/// Natural logarithm of normal positive numbers; anything for others.
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

/// Exponential; below -708 and above 709 that of the limit.
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

/// x^y for positive x.
template <class T>
TALUS_KERNEL T lane_power(T x, double y) {
  return lane_exp(lane_log(x) * y);
}

}  // namespace talus
