// SPDX-License-Identifier: MIT
#include "study/latin_hypercube.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>
#include <utility>

#include "study/normal_law.hpp"
#include "study/random_stream.hpp"

namespace talus::study {
namespace {

using Eigen::MatrixXd;

/// The lower triangle L with L Lᵀ = C.
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

/// Fisher and Yates' shuffle of 0 … count-1.
std::vector<int> draw_permutation(RandomStream& random, int count) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.draw_below(i)]);
  return order;
}

/// The rank of each entry of a column, from 0; equal entries in their order.
std::vector<int> rank_column(const Eigen::Ref<const Eigen::VectorXd>& column) {
  std::vector<int> order(static_cast<std::size_t>(column.size())), rank(order.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return column[a] < column[b]; });
  for (std::size_t i = 0; i < order.size(); ++i) rank[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  return rank;
}

/// The class of every number in every sample of one hypercube: [number][sample].
std::vector<std::vector<int>> pair_classes(std::vector<std::vector<int>> classes, const MatrixXd& wanted) {
  const int numbers = static_cast<int>(classes.size()), samples = static_cast<int>(classes[0].size());
  if (numbers == 1) return classes;
  MatrixXd scores(samples, numbers);  // van der Waerden's
  for (int j = 0; j < numbers; ++j)
    for (int i = 0; i < samples; ++i)
      scores(i, j) = find_normal_score((classes[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] + 1.0) /
                                       (samples + 1.0));
  // Removes the chance correlation of the shuffles, where the samples are enough to estimate it. Lazy products:
  // those of Eigen's own threads would depend on how many there are.
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
