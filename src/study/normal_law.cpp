// SPDX-License-Identifier: MIT
#include "study/normal_law.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/SpecialFunctions>

namespace talus::study {
namespace {

/// The p at which the regularised incomplete beta function I_p(a, b) is `level`.
double invert_beta(double a, double b, double level) {
  double low = 0, high = 1;
  // The function rises: halving the interval cannot fail, and ends when no double lies between.
  for (int i = 0; i < 2000; ++i) {
    const double middle = low > 0 && high < 1e-3 ? std::sqrt(low * high) : 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (Eigen::numext::betainc(a, b, middle) < level ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double find_normal_probability(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

double find_normal_score(double p) {
  if (p <= 0) return -std::numeric_limits<double>::infinity();
  if (p >= 1) return std::numeric_limits<double>::infinity();
  return Eigen::numext::ndtri(p);
}

std::array<double, 2> bound_share(long count, long samples, double confidence) {
  if (samples <= 0) return {0, 1};
  const double k = static_cast<double>(count), n = static_cast<double>(samples), tail = 0.5 * (1 - confidence);
  return {count == 0 ? 0 : invert_beta(k, n - k + 1, tail), count == samples ? 1 : invert_beta(k + 1, n - k, 1 - tail)};
}

}  // namespace talus::study
