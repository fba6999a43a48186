// SPDX-License-Identifier: MIT
// The sparse solver against dense elimination, with changing values on one pattern.

#include "fem/sparse_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

namespace talus::fem {
namespace {

TEST(SparseSolver, AgreesWithDenseEliminationForEveryNewValue) {
  constexpr int n = 40;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> draw(-1, 1);
  std::vector<int> start{0}, row;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i)
      if (std::abs(i - j) <= 2 || (i + j) % 13 == 0) row.push_back(i);
    start.push_back(static_cast<int>(row.size()));
  }
  SparseSolver solver(start, row);
  for (const bool symmetric : {false, true, false, true}) {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
    for (int j = 0; j < n; ++j)
      for (int k = start[static_cast<std::size_t>(j)]; k < start[static_cast<std::size_t>(j) + 1]; ++k)
        dense(row[static_cast<std::size_t>(k)], j) = draw(random);
    if (symmetric) dense = (0.5 * (dense + dense.transpose())).eval();
    dense += 12 * Eigen::MatrixXd::Identity(n, n);
    std::vector<double> values, b, x;
    for (int j = 0; j < n; ++j) {
      b.push_back(draw(random));
      for (int k = start[static_cast<std::size_t>(j)]; k < start[static_cast<std::size_t>(j) + 1]; ++k)
        values.push_back(dense(row[static_cast<std::size_t>(k)], j));
    }
    const Eigen::VectorXd exact = dense.fullPivLu().solve(Eigen::Map<Eigen::VectorXd>(b.data(), n));
    ASSERT_TRUE(solver.factorise(values, symmetric));
    for (int again = 0; again < 2; ++again) {
      ASSERT_TRUE(solver.solve(b, x));
      for (int i = 0; i < n; ++i) EXPECT_NEAR(x[static_cast<std::size_t>(i)], exact[i], 1e-12);
    }
  }
  EXPECT_EQ(solver.factorisations(), 4);
  EXPECT_FALSE(solver.factorise(std::vector<double>(row.size(), 0.0), false)) << "a matrix of zeros is singular";
  std::vector<double> negative(row.size(), 0.0);
  for (int j = 0; j < n; ++j)
    for (int k = start[static_cast<std::size_t>(j)]; k < start[static_cast<std::size_t>(j) + 1]; ++k)
      if (row[static_cast<std::size_t>(k)] == j) negative[static_cast<std::size_t>(k)] = j == 7 ? -1 : 1;
  EXPECT_FALSE(solver.factorise(negative, true)) << "not positive definite";
  EXPECT_TRUE(solver.factorise(negative, false));
}

}  // namespace
}  // namespace talus::fem
