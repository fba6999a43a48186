// SPDX-License-Identifier: MIT
#pragma once
// Rooted Cam-clay in plain loops, independent of the program, by two integrations: small explicit steps of the rate
// equations (4.1–4.10), and one implicit step (4.11–4.15) solved by nested bisection. Compression is positive here.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::reference {

using Tensor3 = Eigen::Matrix3d;

struct PlainClay {
  double lambda = 0, kappa = 0, nu = 0, m_0 = 0, b = 0, p_min = 1e3;
  double r_p = 0, r_a = 0, content = 0;  ///< content in per cent
  double peak = std::numeric_limits<double>::infinity(), range = 0.1, residual = 0;

  double plastic_slope(double e) const { return (1 + e) / (lambda - kappa); }
  double g_over_k() const { return 3 * (1 - 2 * nu) / (2 * (1 + nu)); }
};

struct PlainClayState {
  Tensor3 stress = Tensor3::Zero();  ///< effective, compression positive [Pa]
  double p_b = 0, e = 0, h = 0, eps_r = 0, share = 1, saturation = 1;
};

inline Tensor3 find_deviator(const Tensor3& t) {
  return t - t.trace() / 3 * Tensor3::Identity();
}
inline double find_q(const Tensor3& stress) {
  return std::sqrt(1.5) * find_deviator(stress).norm();
}
inline double find_slope(const PlainClay& c, const PlainClayState& s) {
  return c.m_0 + s.share * c.r_a * c.content;
}
inline double find_p_c(const PlainClay& c, const PlainClayState& s) {
  return std::max(1e-3 * c.p_min, s.p_b * std::exp(c.b * (1 - s.saturation) + s.share * s.h));
}
inline double find_yield(const PlainClay& c, const PlainClayState& s) {
  const double p = s.stress.trace() / 3, q = find_q(s.stress), m = find_slope(c, s);
  return q * q / (m * m) - p * (find_p_c(c, s) - p);
}

/// Advances roots and void ratio by an increment, before the stress; the rates use e at the middle of the increment.
void advance_roots(const PlainClay& c, PlainClayState& s, const Tensor3& d);

/// Strain increment `d`, small: elastic predictor and a cutting plane at the stress itself, repeated.
void step_explicitly(const PlainClay& c, PlainClayState& s, const Tensor3& d);

/// p', q and p'_c after a return that keeps p'_c at `p_c`: the multiplier by bisection. Not plastic: as they were.
struct ClosestPoint {
  double p, q, multiplier;
};
ClosestPoint find_closest(double p, double q, double p_c, double k, double g, double m);

/// One implicit step with the strain increment `d`, as large as it may be: p'_c by bisection over its logarithm.
void step_implicitly(const PlainClay& c, PlainClayState& s, const Tensor3& d);

}  // namespace talus::reference
