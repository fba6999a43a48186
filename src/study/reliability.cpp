// SPDX-License-Identifier: MIT
#include "study/sampled_numbers.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "study/distributions.hpp"

namespace talus::study {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Width of a difference quotient in scores. A smaller one would be dominated by the jumps of the factor where the
/// critical surface changes.
constexpr double score_step = 0.05;
constexpr int most_iterations = 50, most_halvings = 8;
constexpr double index_tolerance = 1e-3, factor_tolerance = 1e-3;

/// Correlation of two scores.
double get(const SampledNumbers& sampled, std::size_t i, std::size_t j) {
  return sampled.correlation.empty() ? (i == j ? 1.0 : 0.0) : sampled.correlation[i * sampled.numbers.size() + j];
}

/// F as a function of independent scores.
class ScoreFactor {
 public:
  ScoreFactor(const SampledNumbers& sampled, const FactorOf& factor) : numbers_(sampled.marginals), factor_(factor) {
    const auto n = static_cast<Eigen::Index>(numbers_.size());
    MatrixXd c(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j)
        c(i, j) = get(sampled, static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    lower_ = c.llt().matrixL();
  }

  std::vector<double> find_values(const VectorXd& y) const {
    const VectorXd z = lower_.lazyProduct(y);
    std::vector<double> values;
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      values.push_back(numbers_[i].find_value(z[static_cast<Eigen::Index>(i)]));
    return values;
  }
  std::optional<double> operator()(const VectorXd& y) const { return factor_(find_values(y)); }

  bool find_gradient(const VectorXd& y, VectorXd& gradient) const {
    gradient.resize(y.size());
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      VectorXd low = y, high = y;
      low[i] -= score_step;
      high[i] += score_step;
      const std::optional<double> a = (*this)(low), b = (*this)(high);
      if (!a || !b) return false;
      gradient[i] = (*b - *a) / (2 * score_step);
    }
    return true;
  }

 private:
  const std::vector<Marginal>& numbers_;
  const FactorOf& factor_;
  MatrixXd lower_;
};

}  // namespace

double find_lognormal_index(double mean, double deviation) {
  const double v = deviation / mean;
  return std::log(mean / std::sqrt(1 + v * v)) / std::sqrt(std::log1p(v * v));
}

void estimate_first_order(const SampledNumbers& sampled, const FactorOf& factor, results::Sampling& result) {
  const std::vector<Marginal>& numbers = sampled.marginals;
  const std::optional<double> mean = factor(sampled.means);
  if (!mean) return;
  std::vector<results::TornadoBar> bars;
  std::vector<double> slope;  // change of F per standard deviation
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double deviation = numbers[i].find_deviation();
    std::vector<double> low = sampled.means, high = sampled.means;
    low[i] = std::max(low[i] - deviation, numbers[i].lowest);
    high[i] = std::min(high[i] + deviation, numbers[i].highest);
    const std::optional<double> a = factor(low), b = factor(high);
    if (!a || !b) return;
    const results::UncertainNumber& n = sampled.numbers[i];
    bars.push_back({n.key, n.name, n.unit, low[i], high[i], *a, *b});
    slope.push_back(high[i] > low[i] ? (*b - *a) / (high[i] - low[i]) * deviation : 0);
  }
  double variance = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t j = 0; j < numbers.size(); ++j) {
      const double scores = get(sampled, i, j);
      const double values = i == j ? 1 : scores == 0 ? 0 : correlate_values(numbers[i], numbers[j], scores);
      variance += slope[i] * slope[j] * values;
    }
  const double deviation = std::sqrt(std::max(0.0, variance));
  if (deviation == 0) return;
  result.first_order = {*mean, deviation, (*mean - 1) / deviation, find_lognormal_index(*mean, deviation)};
  const auto length = [](const results::TornadoBar& bar) { return std::abs(bar.high_factor - bar.low_factor); };
  std::stable_sort(bars.begin(), bars.end(), [&](const auto& a, const auto& b) { return length(a) > length(b); });
  result.tornado = std::move(bars);
}

std::optional<results::DesignPointEstimate> find_design_point(const SampledNumbers& sampled, const FactorOf& factor) {
  const ScoreFactor factor_of(sampled, factor);
  VectorXd y = VectorXd::Zero(static_cast<Eigen::Index>(sampled.numbers.size())), gradient;
  const std::optional<double> start = factor_of(y);
  if (!start) return std::nullopt;
  results::DesignPointEstimate point;
  double g = *start - 1;
  const double sign = g >= 0 ? 1 : -1;
  for (; point.iterations < most_iterations && !point.converged; ++point.iterations) {
    if (!factor_of.find_gradient(y, gradient) || gradient.squaredNorm() == 0) return std::nullopt;
    const VectorXd target = gradient * (gradient.dot(y) - g) / gradient.squaredNorm();
    const VectorXd step = target - y;
    // A step is accepted if it decreases this merit function (Zhang and Der Kiureghian 1995).
    const double weight = 2 * std::max(y.norm() / gradient.norm(), 10 * target.squaredNorm() / (1 + std::abs(g)));
    const auto merit = [weight](const VectorXd& at, double value) {
      return 0.5 * at.squaredNorm() + weight * std::abs(value);
    };
    double share = 1;
    std::optional<double> next;
    for (int i = 0; i < most_halvings; ++i, share *= 0.5) {
      next = factor_of(y + share * step);
      if (next && merit(y + share * step, *next - 1) < merit(y, g)) break;
    }
    if (!next) return std::nullopt;
    point.converged = std::abs(*next - 1) < factor_tolerance && step.norm() * share < std::sqrt(index_tolerance) &&
                      std::abs(target.norm() - y.norm()) < index_tolerance * std::max(1.0, y.norm());
    y += share * step;
    g = *next - 1;
  }
  point.index = sign * y.norm();
  point.probability = find_normal_probability(-point.index);
  point.factor = 1 + g;
  const std::vector<double> values = factor_of.find_values(y);
  const double square = y.squaredNorm();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const results::UncertainNumber& n = sampled.numbers[i];
    const double component = y[static_cast<Eigen::Index>(i)];
    point.values.push_back({n.key, n.name, n.unit, values[i], square > 0 ? component * component / square : 0});
  }
  return point;
}

}  // namespace talus::study
