// SPDX-License-Identifier: MIT
#include "study/distributions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/SpecialFunctions>
#include <utility>

namespace talus::study {

namespace {

/// Returns p for which the regularised incomplete beta function I_p(a, b) is `level`.
double invert_beta(double a, double b, double level) {
  double low = 0, high = 1;
  // I_p is monotonic, so bisection converges; it ends when no double lies between the limits.
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

/// Probability between two scores, computed from the tail in which they lie.
double find_between(double low, double high) {
  return low > 0 ? find_normal_probability(-low) - find_normal_probability(-high)
                 : find_normal_probability(high) - find_normal_probability(low);
}

double find_density(double z) {
  return std::isinf(z) ? 0 : std::exp(-0.5 * z * z) / std::sqrt(2 * M_PI);
}

/// Returns the score in the uncut distribution below which the fraction Φ(score) of the probability between the cuts
/// lies (docs/theory/20-probability.md).
double move_between_cuts(double score, double low, double high) {
  const double share = find_between(low, high);
  // Probabilities are counted from the nearer tail to retain their digits.
  if (score <= 0) {
    const double p = find_normal_probability(low) + find_normal_probability(score) * share;
    return p < 0.5 ? find_normal_score(p)
                   : -find_normal_score(find_normal_probability(-low) - find_normal_probability(score) * share);
  }
  const double q = find_normal_probability(-high) + find_normal_probability(-score) * share;
  return q < 0.5 ? -find_normal_score(q)
                 : find_normal_score(find_normal_probability(high) - find_normal_probability(-score) * share);
}

/// First and second moment of the cut distribution.
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
  // Golub and Welsch (1969): abscissae and weights from the Jacobi matrix of the Hermite polynomials.
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

namespace {

constexpr std::uint64_t multiplier_0 = 0xD2511F53, multiplier_1 = 0xCD9E8D57;
constexpr std::uint32_t weyl_0 = 0x9E3779B9, weyl_1 = 0xBB67AE85;
constexpr int rounds = 10;

std::uint32_t take_low(std::uint64_t x) {
  return static_cast<std::uint32_t>(x & 0xFFFFFFFF);
}
std::uint32_t take_high(std::uint64_t x) {
  return static_cast<std::uint32_t>(x >> 32);
}

}  // namespace

std::array<std::uint32_t, 4> scramble(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
  for (int i = 0; i < rounds; ++i) {
    const std::uint64_t a = multiplier_0 * counter[0], b = multiplier_1 * counter[2];
    counter = {take_high(b) ^ counter[1] ^ key[0], take_low(b), take_high(a) ^ counter[3] ^ key[1], take_low(a)};
    key[0] += weyl_0;
    key[1] += weyl_1;
  }
  return counter;
}

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream)
    : key_{take_low(seed), take_high(seed)}, stream_(stream) {}

std::uint64_t RandomStream::draw_bits() {
  const std::uint64_t block = drawn_ / 2;
  if (drawn_ % 2 == 0)
    words_ = scramble({take_low(block), take_high(block), take_low(stream_), take_high(stream_)}, key_);
  const std::size_t first = 2 * (drawn_++ % 2);
  return (static_cast<std::uint64_t>(words_[first]) << 32) | words_[first + 1];
}

double RandomStream::draw_uniform() {
  return (static_cast<double>(draw_bits() >> 12) + 0.5) * 0x1p-52;  // 52 bits and a half: never 0 nor 1 after rounding
}

std::uint64_t RandomStream::draw_below(std::uint64_t count) {
  // Numbers above the largest multiple of `count` are rejected, as they would favour the first remainders.
  const std::uint64_t usable = UINT64_MAX - UINT64_MAX % count;
  std::uint64_t bits = draw_bits();
  while (bits >= usable) bits = draw_bits();
  return bits % count;
}

namespace {

using Eigen::MatrixXd;

/// Lower triangular L with L Lᵀ = C.
MatrixXd factorise(const ScorePlan& plan) {
  if (plan.correlation.empty()) return MatrixXd::Identity(plan.numbers, plan.numbers);
  MatrixXd c(plan.numbers, plan.numbers);
  std::size_t at = 0;
  for (int i = 0; i < plan.numbers; ++i)
    for (int j = 0; j < plan.numbers; ++j) c(i, j) = plan.correlation[at++];
  return c.llt().matrixL();
}

RandomStream make_stream(const ScorePlan& plan, int replicate, int number) {
  return {plan.seed, (static_cast<std::uint64_t>(replicate) << 32) + static_cast<std::uint64_t>(number)};
}

/// Fisher–Yates shuffle of 0 … count-1.
std::vector<int> draw_permutation(RandomStream& random, int count) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.draw_below(i)]);
  return order;
}

/// Returns the rank of each entry of a column, from 0; equal entries keep their order.
std::vector<int> rank_column(const Eigen::Ref<const Eigen::VectorXd>& column) {
  std::vector<int> order(static_cast<std::size_t>(column.size())), rank(order.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return column[a] < column[b]; });
  for (std::size_t i = 0; i < order.size(); ++i) rank[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  return rank;
}

/// Returns the class of every number in every sample of one hypercube: [number][sample] (T20.3).
std::vector<std::vector<int>> pair_classes(std::vector<std::vector<int>> classes, const MatrixXd& wanted) {
  const int numbers = static_cast<int>(classes.size()), samples = static_cast<int>(classes[0].size());
  if (numbers == 1) return classes;
  MatrixXd scores(samples, numbers);  // van der Waerden scores
  for (int j = 0; j < numbers; ++j)
    for (int i = 0; i < samples; ++i)
      scores(i, j) = find_normal_score((classes[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] + 1.0) /
                                       (samples + 1.0));
  // Removes the chance correlation of the shuffles if there are enough samples to estimate it. The products are lazy,
  // because those on Eigen's threads would depend on the number of threads.
  MatrixXd change = wanted.transpose();
  if (samples > 2 * numbers) {
    const MatrixXd found = scores.transpose().lazyProduct(scores) / scores.col(0).squaredNorm();
    const Eigen::LLT<MatrixXd> chance(found);
    if (chance.info() == Eigen::Success) change = chance.matrixU().solve(change).eval();
  }
  scores = scores.lazyProduct(change).eval();
  for (int j = 0; j < numbers; ++j) classes[static_cast<std::size_t>(j)] = rank_column(scores.col(j));
  return classes;
}

void draw_hypercube(const ScorePlan& plan, int replicate, const MatrixXd& wanted,
                    std::vector<std::vector<double>>& scores) {
  const int first = find_first(plan, replicate), samples = find_first(plan, replicate + 1) - first;
  std::vector<RandomStream> random;
  std::vector<std::vector<int>> classes;
  for (int j = 0; j < plan.numbers; ++j) {
    random.push_back(make_stream(plan, replicate, j));
    classes.push_back(draw_permutation(random.back(), samples));
  }
  classes = pair_classes(std::move(classes), wanted);
  for (std::size_t j = 0; j < classes.size(); ++j)
    for (std::size_t i = 0; i < classes[j].size(); ++i)
      scores[j][static_cast<std::size_t>(first) + i] =
          find_normal_score((classes[j][i] + random[j].draw_uniform()) / samples);
}

}  // namespace

int find_first(const ScorePlan& plan, int replicate) {
  return static_cast<int>(static_cast<long>(plan.samples) * replicate / plan.replicates);
}

std::vector<std::vector<double>> draw_scores(const ScorePlan& plan) {
  const MatrixXd wanted = factorise(plan);
  std::vector<std::vector<double>> scores(static_cast<std::size_t>(plan.numbers),
                                          std::vector<double>(static_cast<std::size_t>(plan.samples)));
  if (plan.latin) {
    for (int r = 0; r < plan.replicates; ++r) draw_hypercube(plan, r, wanted, scores);
    return scores;
  }
  std::vector<RandomStream> random;
  for (int j = 0; j < plan.numbers; ++j) random.push_back(make_stream(plan, 0, j));
  Eigen::VectorXd independent(plan.numbers);
  for (int i = 0; i < plan.samples; ++i) {
    for (int j = 0; j < plan.numbers; ++j)
      independent[j] = find_normal_score(random[static_cast<std::size_t>(j)].draw_uniform());
    const Eigen::VectorXd row = wanted.lazyProduct(independent);
    for (int j = 0; j < plan.numbers; ++j) scores[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = row[j];
  }
  return scores;
}

}  // namespace talus::study
