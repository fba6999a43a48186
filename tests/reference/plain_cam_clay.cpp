// SPDX-License-Identifier: MIT
#include "reference/plain_cam_clay.hpp"

namespace talus::reference {

void advance_roots(const PlainClay& c, PlainClayState& s, const Tensor3& d) {
  const double volume = d.trace(), e_before = s.e;
  s.e = (1 + s.e) * std::exp(-volume) - 1;
  const double mean_e = std::abs(volume) < 1e-12 ? s.e : (e_before - s.e) / volume - 1;
  const double activation = volume + std::sqrt(2.0 / 3) * find_deviator(d).norm();
  s.eps_r += activation;
  s.h += c.r_p * c.content * mean_e * activation;
  const double left = std::clamp(1 - (s.eps_r - c.peak) / c.range, 0.0, 1.0);
  if (std::isfinite(c.peak)) s.share = std::min(s.share, c.residual + (1 - c.residual) * left);
}

void step_explicitly(const PlainClay& c, PlainClayState& s, const Tensor3& d) {
  const double e = s.e, k = (1 + e) * std::max(s.stress.trace() / 3, c.p_min) / c.kappa, g = c.g_over_k() * k;
  advance_roots(c, s, d);
  s.stress += k * d.trace() * Tensor3::Identity() + 2 * g * find_deviator(d);
  for (int i = 0; i < 50; ++i) {
    const double f = find_yield(c, s), p_c = find_p_c(c, s), p = s.stress.trace() / 3, m = find_slope(c, s);
    if (f <= 1e-13 * p_c * p_c) break;
    const double f_p = 2 * p - p_c;
    const Tensor3 dev = 3 / (m * m) * find_deviator(s.stress);  // ∂f/∂s
    const double multiplier = f / (k * f_p * f_p + 2 * g * dev.squaredNorm() + c.plastic_slope(e) * p * p_c * f_p);
    s.stress -= multiplier * (k * f_p * Tensor3::Identity() + 2 * g * dev);
    s.p_b *= std::exp(c.plastic_slope(e) * multiplier * f_p);
  }
}

ClosestPoint find_closest(double p, double q, double p_c, double k, double g, double m) {
  const auto at = [&](double l) {
    return ClosestPoint{(p + k * l * p_c) / (1 + 2 * k * l), q / (1 + 6 * g * l / (m * m)), l};
  };
  const auto f = [&](double l) { return at(l).q * at(l).q / (m * m) - at(l).p * (p_c - at(l).p); };
  if (f(0) <= 0) return at(0);
  double low = 0, high = 1e-9 / (k + g);
  while (f(high) > 0) high *= 2;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0 ? low : high) = middle;
  }
  return at(high);
}

void step_implicitly(const PlainClay& c, PlainClayState& s, const Tensor3& d) {
  const double volume = d.trace(), e = s.e, p_before = s.stress.trace() / 3;
  const double specific = std::abs(volume) < 1e-9 ? 1 + e : (1 + e) * (1 - std::exp(-volume)) / volume;
  double k = specific * std::max(p_before, c.p_min) / c.kappa;
  if (p_before > c.p_min) {  // secant of the swelling line
    const double x = std::clamp(specific * volume / c.kappa, -1.0, 1.0);
    double sum = 0, term = 1;
    for (int i = 1; i <= 6; ++i) {
      sum += term / i;
      term *= x / i;
    }
    k *= sum;
  }
  const double g = c.g_over_k() * k;
  advance_roots(c, s, d);
  const double p = p_before + k * volume, m = find_slope(c, s), trial_p_c = find_p_c(c, s);
  const Tensor3 deviator = find_deviator(s.stress) + 2 * g * find_deviator(d);
  const double q = std::sqrt(1.5) * deviator.norm(), theta = specific / (c.lambda - c.kappa);
  const double least = std::log(1e-3 * c.p_min / trial_p_c);
  // z = ln(p'_c / trial p'_c): what it implies, less itself
  const auto excess = [&](double z) {
    const double p_c = trial_p_c * std::exp(z);
    const ClosestPoint point = find_closest(p, q, p_c, k, g, m);
    return std::max(least, theta * point.multiplier * (2 * point.p - p_c)) - z;
  };
  // The root next to the trial: soil that softens much within the step may have others.
  const bool hardens = excess(0) > 0;
  double near = 0, far = 0;
  for (double width = 1e-3; (excess(far) > 0) == hardens && far > least; width *= 1.2) {
    near = far;
    far = std::max(least, far + (hardens ? width : -width));
  }
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (near + far);
    ((excess(middle) > 0) == hardens ? near : far) = middle;
  }
  const bool elastic = find_closest(p, q, trial_p_c, k, g, m).multiplier == 0;
  const double p_c = elastic ? trial_p_c : trial_p_c * std::exp(far);
  const ClosestPoint point = find_closest(p, q, p_c, k, g, m);
  s.stress = point.p * Tensor3::Identity() + (q > 0 ? point.q / q : 1) * deviator;
  s.p_b *= p_c / trial_p_c;
}

}  // namespace talus::reference
