// SPDX-License-Identifier: MIT
#pragma once
// Forward-mode automatic differentiation: a value with its derivatives by N variables, used like a double. A
// constitutive law written for lanes yields its consistent tangent in these numbers. Comparisons use the value only.

#include <cmath>
#include <type_traits>

#include "base/lane.hpp"

namespace talus {

namespace detail {
typedef double Row4 __attribute__((vector_size(32)));
typedef double Row8 __attribute__((vector_size(64)));
}  // namespace detail

template <int N>
struct Dual {
  static constexpr int derivatives = N;
  static_assert(N >= 1 && N <= 8);
  using Vector = std::conditional_t<(N <= 4), detail::Row4, detail::Row8>;

  double value;
  Vector slope;  ///< ∂value/∂x_i

  Dual() = default;
  TALUS_KERNEL Dual(double v) : value(v), slope(Vector{}) {}
  TALUS_KERNEL Dual(double v, Vector s) : value(v), slope(s) {}

  /// Returns the independent variable i with value v.
  static Dual variable(double v, int i) {
    Dual r(v);
    r.slope[i] = 1;
    return r;
  }

  TALUS_KERNEL friend Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.slope + b.slope}; }
  TALUS_KERNEL friend Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.slope - b.slope}; }
  TALUS_KERNEL friend Dual operator*(Dual a, Dual b) {
    return {a.value * b.value, a.slope * b.value + b.slope * a.value};
  }
  TALUS_KERNEL friend Dual operator*(double a, Dual b) { return {a * b.value, a * b.slope}; }
  TALUS_KERNEL friend Dual operator*(Dual a, double b) { return {a.value * b, a.slope * b}; }
  TALUS_KERNEL friend Dual operator/(Dual a, Dual b) {
    const double inverse = 1 / b.value, quotient = a.value / b.value;
    return {quotient, (a.slope - b.slope * quotient) * inverse};
  }
  TALUS_KERNEL Dual operator-() const { return {-value, -slope}; }
  TALUS_KERNEL Dual& operator+=(Dual b) { return *this = *this + b; }
  TALUS_KERNEL Dual& operator-=(Dual b) { return *this = *this - b; }
  TALUS_KERNEL Dual& operator*=(Dual b) { return *this = *this * b; }

  TALUS_KERNEL friend bool operator<(Dual a, Dual b) { return a.value < b.value; }
  TALUS_KERNEL friend bool operator>(Dual a, Dual b) { return a.value > b.value; }
  TALUS_KERNEL friend bool operator==(Dual a, Dual b) { return a.value == b.value; }
};

template <int N>
struct LaneTraits<Dual<N>> {
  using mask = bool;
  static constexpr int width = 1;
};

template <int N>
TALUS_KERNEL Dual<N> select(bool c, Dual<N> a, Dual<N> b) {
  return c ? a : b;
}
template <int N>
TALUS_KERNEL Dual<N> lane_max(Dual<N> a, Dual<N> b) {
  return a.value > b.value ? a : b;
}
template <int N>
TALUS_KERNEL Dual<N> lane_min(Dual<N> a, Dual<N> b) {
  return a.value < b.value ? a : b;
}
template <int N>
TALUS_KERNEL Dual<N> lane_abs(Dual<N> a) {
  return a.value < 0 ? -a : a;
}
/// The derivative at 0 is set to 0: roots of sums of squares have a kink there, with mean slope 0.
template <int N>
TALUS_KERNEL Dual<N> lane_sqrt(Dual<N> a) {
  const double root = std::sqrt(a.value);
  return {root, root > 0 ? a.slope * (0.5 / root) : typename Dual<N>::Vector{}};
}
template <int N>
TALUS_KERNEL Dual<N> lane_log(Dual<N> a) {
  return {lane_log(a.value), a.slope * (1 / a.value)};
}
template <int N>
TALUS_KERNEL Dual<N> lane_exp(Dual<N> a) {
  const double e = lane_exp(a.value);
  return {e, a.slope * e};
}

}  // namespace talus
