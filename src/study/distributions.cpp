// SPDX-License-Identifier: MIT
#include "study/distributions.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "study/normal_law.hpp"

namespace talus::study {
namespace {

using input::Distribution;

/// ζ and λ of ln X ~ N(λ, ζ²).
struct LogMoments {
  explicit LogMoments(const Marginal& m)
      : deviation(std::sqrt(std::log1p(m.deviation * m.deviation / (m.mean * m.mean)))),
        mean(std::log(m.mean) - 0.5 * deviation * deviation) {}
  double deviation, mean;
};

/// Score of `x` in the uncut normal or lognormal distribution.
double find_plain_score(const Marginal& m, double x) {
  if (m.kind == Distribution::normal) return (x - m.mean) / m.deviation;
  const LogMoments log(m);
  return x <= 0 ? -std::numeric_limits<double>::infinity() : (std::log(x) - log.mean) / log.deviation;
}

double find_plain_value(const Marginal& m, double score) {
  if (m.kind == Distribution::normal) return m.mean + m.deviation * score;
  const LogMoments log(m);
  return std::exp(log.mean + log.deviation * score);
}

bool is_bell(const Marginal& m) {
  return m.kind == Distribution::normal || m.kind == Distribution::lognormal;
}

/// Probability between two scores, from the tail in which they lie.
double find_between(double low, double high) {
  return low > 0 ? find_normal_probability(-low) - find_normal_probability(-high)
                 : find_normal_probability(high) - find_normal_probability(low);
}

double find_density(double z) {
  return std::isinf(z) ? 0 : std::exp(-0.5 * z * z) / std::sqrt(2 * M_PI);
}

/// The score in the uncut distribution that leaves the share Φ(score) of what lies between the cuts below it.
double move_between_cuts(double score, double low, double high) {
  const double share = find_between(low, high);
  // Counted from the nearer tail, so that neither loses its digits.
  if (score <= 0) {
    const double p = find_normal_probability(low) + find_normal_probability(score) * share;
    return p < 0.5 ? find_normal_score(p)
                   : -find_normal_score(find_normal_probability(-low) - find_normal_probability(score) * share);
  }
  const double q = find_normal_probability(-high) + find_normal_probability(-score) * share;
  return q < 0.5 ? -find_normal_score(q)
                 : find_normal_score(find_normal_probability(high) - find_normal_probability(-score) * share);
}

/// First and second moment of the distribution as it is cut.
std::array<double, 2> find_moments(const Marginal& m) {
  const double a = m.lowest, b = m.highest, c = m.mode;
  if (m.kind == Distribution::uniform) return {0.5 * (a + b), (a * a + a * b + b * b) / 3};
  if (m.kind == Distribution::triangular) {
    const double mean = (a + b + c) / 3;
    return {mean, (a * a + b * b + c * c - a * b - a * c - b * c) / 18 + mean * mean};
  }
  const double low = find_plain_score(m, a), high = find_plain_score(m, b), share = find_between(low, high);
  if (m.kind == Distribution::normal) {
    const auto times = [](double z, double f) { return std::isinf(z) ? 0 : z * f; };
    const double shift = (find_density(low) - find_density(high)) / share;
    const double second = 1 + (times(low, find_density(low)) - times(high, find_density(high))) / share;
    return {m.mean + m.deviation * shift,
            m.mean * m.mean + 2 * m.mean * m.deviation * shift + m.deviation * m.deviation * second};
  }
  const LogMoments log(m);
  const auto moment = [&](double k) {
    return std::exp(k * log.mean + 0.5 * k * k * log.deviation * log.deviation) *
           find_between(low - k * log.deviation, high - k * log.deviation) / share;
  };
  return {moment(1), moment(2)};
}

}  // namespace

double Marginal::find_value(double score) const {
  if (is_bell(*this)) {
    if (deviation == 0) return mean;
    if (std::isinf(lowest) && std::isinf(highest)) return find_plain_value(*this, score);
    const double cut = move_between_cuts(score, find_plain_score(*this, lowest), find_plain_score(*this, highest));
    return std::clamp(find_plain_value(*this, cut), lowest, highest);
  }
  const double p = find_normal_probability(score), q = find_normal_probability(-score);
  if (kind == Distribution::uniform)
    return score < 0 ? lowest + p * (highest - lowest) : highest - q * (highest - lowest);
  const double width = highest - lowest, rise = (mode - lowest) / width;
  return p <= rise ? lowest + std::sqrt(p * width * (mode - lowest))
                   : highest - std::sqrt(q * width * (highest - mode));
}

double Marginal::find_probability(double x) const {
  if (x <= lowest) return 0;
  if (x >= highest) return 1;
  if (is_bell(*this)) {
    if (deviation == 0) return x < mean ? 0 : 1;
    const double low = find_plain_score(*this, lowest), high = find_plain_score(*this, highest);
    return find_between(low, find_plain_score(*this, x)) / find_between(low, high);
  }
  const double width = highest - lowest;
  if (kind == Distribution::uniform) return (x - lowest) / width;
  return x <= mode ? (x - lowest) * (x - lowest) / (width * (mode - lowest))
                   : 1 - (highest - x) * (highest - x) / (width * (highest - mode));
}

double Marginal::find_mean() const {
  return is_bell(*this) && deviation == 0 ? mean : find_moments(*this)[0];
}

double Marginal::find_deviation() const {
  if (is_bell(*this) && (deviation == 0 || (std::isinf(lowest) && std::isinf(highest)))) return deviation;
  const auto [first, second] = find_moments(*this);
  return std::sqrt(std::max(0.0, second - first * first));
}

double Marginal::find_cut_share() const {
  if (!is_bell(*this) || deviation == 0) return 0;
  const double low = find_plain_score(*this, lowest), high = find_plain_score(*this, highest);
  return find_normal_probability(low) + find_normal_probability(-high);
}

double correlate_values(const Marginal& a, const Marginal& b, double coefficient) {
  // Golub and Welsch (1969): abscissae and weights from the Jacobi matrix of Hermite's polynomials.
  constexpr int points = 40;
  static const auto rule = [] {
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(points, points);
    for (int i = 1; i < points; ++i) jacobi(i, i - 1) = jacobi(i - 1, i) = std::sqrt(static_cast<double>(i));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi);
    return std::pair<Eigen::VectorXd, Eigen::VectorXd>(solver.eigenvalues(),
                                                       solver.eigenvectors().row(0).transpose().array().square());
  }();
  const double rest = std::sqrt(std::max(0.0, 1 - coefficient * coefficient));
  double product = 0;
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j)
      product += rule.second[i] * rule.second[j] * a.find_value(rule.first[i]) *
                 b.find_value(coefficient * rule.first[i] + rest * rule.first[j]);
  return (product - a.find_mean() * b.find_mean()) / (a.find_deviation() * b.find_deviation());
}

}  // namespace talus::study
