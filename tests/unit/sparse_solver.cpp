// SPDX-License-Identifier: MIT
// The sparse solver against dense elimination and by residuals, with changing values on one pattern.

#include "sparse/gmres.hpp"
#include "sparse/solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

namespace talus::sparse {
namespace {

struct Matrix {
  std::vector<int> start{0}, row;
  std::vector<double> values;

  int size() const { return static_cast<int>(start.size()) - 1; }
  std::vector<double> times(const std::vector<double>& x) const {
    std::vector<double> y(x.size(), 0);
    for (int j = 0; j < size(); ++j)
      for (int k = start[j]; k < start[j + 1]; ++k) y[row[k]] += values[k] * x[j];
    return y;
  }
};

/// Returns the pattern of a cube of n³ nodes with `unknowns` each, every node coupled with its 26 neighbours.
Matrix make_cube(int n, int unknowns) {
  Matrix m;
  const int nodes = n * n * n;
  for (int node = 0; node < nodes; ++node) {
    std::vector<int> rows;
    for (int other = 0; other < nodes; ++other)
      if (std::abs(node % n - other % n) <= 1 && std::abs(node / n % n - other / n % n) <= 1 &&
          std::abs(node / n / n - other / n / n) <= 1)
        for (int u = 0; u < unknowns; ++u) rows.push_back(other * unknowns + u);
    for (int u = 0; u < unknowns; ++u) {
      m.row.insert(m.row.end(), rows.begin(), rows.end());
      m.start.push_back(static_cast<int>(m.row.size()));
    }
  }
  return m;
}

/// Fills a matrix with entries between -1 and 1 and adds `diagonal`, with changing signs if `indefinite`.
void fill(Matrix& m, double diagonal, bool symmetric, bool indefinite, unsigned seed) {
  const auto draw = [seed](int i, int j) { return std::sin(seed + 12.9898 * i + 78.233 * j); };
  m.values.clear();
  for (int j = 0; j < m.size(); ++j)
    for (int k = m.start[j]; k < m.start[j + 1]; ++k) {
      const int i = m.row[k];
      m.values.push_back(symmetric ? draw(std::min(i, j), std::max(i, j)) : draw(i, j));
      if (i == j) m.values.back() += indefinite && i % 3 == 0 ? -diagonal : diagonal;
    }
}

std::vector<double> draw_right(int n) {
  std::mt19937 random(3);
  std::vector<double> b;
  for (int i = 0; i < n; ++i) b.push_back(std::uniform_real_distribution<double>(-1, 1)(random));
  return b;
}

double find_residual(const Matrix& m, const std::vector<double>& x, const std::vector<double>& b) {
  const std::vector<double> y = m.times(x);
  double largest = 0;
  for (std::size_t i = 0; i < b.size(); ++i) largest = std::max(largest, std::abs(y[i] - b[i]));
  return largest;
}

TEST(SparseSolver, AgreesWithDenseEliminationForEveryNewValue) {
  constexpr int n = 40;
  Matrix m;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i)
      if (std::abs(i - j) <= 2 || (i + j) % 13 == 0) m.row.push_back(i);
    m.start.push_back(static_cast<int>(m.row.size()));
  }
  SparseSolver solver(m.start, m.row);
  const std::vector<double> b = draw_right(n);
  for (const bool symmetric : {false, true, false, true}) {
    fill(m, 12, symmetric, false, 5);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
    for (int j = 0; j < n; ++j)
      for (int k = m.start[j]; k < m.start[j + 1]; ++k) dense(m.row[k], j) = m.values[k];
    const Eigen::VectorXd exact = dense.fullPivLu().solve(Eigen::Map<const Eigen::VectorXd>(b.data(), n));
    ASSERT_TRUE(solver.factorise(m.values, symmetric ? Factors::ldlt : Factors::lu));
    for (int again = 0; again < 2; ++again) {
      std::vector<double> x = b;
      ASSERT_TRUE(solver.solve(x));
      for (int i = 0; i < n; ++i) EXPECT_NEAR(x[i], exact[i], 1e-12);
    }
  }
  EXPECT_EQ(solver.factorisations(), 4);
}

TEST(SparseSolver, RefusesSingularMatricesAndCountsNegativePivots) {
  Matrix m = make_cube(4, 2);
  SparseSolver solver(m.start, m.row);
  const std::vector<double> zeros(m.row.size(), 0.0);
  EXPECT_FALSE(solver.factorise(zeros, Factors::lu));
  EXPECT_FALSE(solver.factorise(zeros, Factors::ldlt));
  fill(m, 60, true, true, 1);
  ASSERT_TRUE(solver.factorise(m.values, Factors::ldlt));
  EXPECT_EQ(solver.negative_pivots(), (m.size() + 2) / 3) << "rows that dominate with a negative diagonal";
  const std::vector<double> b = draw_right(m.size());
  std::vector<double> x = b;
  ASSERT_TRUE(solver.solve(x));
  EXPECT_LT(find_residual(m, x, b), 1e-13);
}

TEST(SparseSolver, TakesTheLowerTriangleAlone) {
  Matrix m = make_cube(4, 2), lower;
  fill(m, 60, true, true, 4);
  for (int j = 0; j < m.size(); ++j) {
    for (int k = m.start[j]; k < m.start[j + 1]; ++k)
      if (m.row[k] >= j) lower.row.push_back(m.row[k]), lower.values.push_back(m.values[k]);
    lower.start.push_back(static_cast<int>(lower.row.size()));
  }
  SparseSolver all(m.start, m.row), half(lower.start, lower.row, 1, Stored::lower);
  ASSERT_TRUE(all.factorise(m.values, Factors::ldlt));
  ASSERT_TRUE(half.factorise(lower.values, Factors::ldlt));
  std::vector<double> x = draw_right(m.size()), y = x;
  ASSERT_TRUE(all.solve(x));
  ASSERT_TRUE(half.solve(y));
  EXPECT_EQ(x, y);
}

/// A cube whose elimination nested dissection orders, and which has fronts of several hundred unknowns.
TEST(SparseSolver, SolvesLargeSystemsBitwiseEqualWithAnyThreads) {
  Matrix m = make_cube(14, 3);
  const Elimination plan = plan_elimination(m.start, m.row);
  int largest = 0;
  for (const Front& front : plan.fronts) largest = std::max(largest, front.size());
  EXPECT_GT(plan.work, 1e9);
  EXPECT_GT(largest, 300);
  const std::vector<double> b = draw_right(m.size());
  for (const auto factors : {Factors::lu, Factors::ldlt}) {
    fill(m, 90, factors == Factors::ldlt, false, 2);
    std::vector<std::vector<double>> solutions;
    for (const int threads : {1, 2, 3}) {
      SparseSolver solver(m.start, m.row, threads);
      ASSERT_TRUE(solver.factorise(m.values, factors));
      solutions.push_back(b);
      ASSERT_TRUE(solver.solve(solutions.back()));
    }
    EXPECT_LT(find_residual(m, solutions[0], b), 1e-13);
    EXPECT_EQ(solutions[0], solutions[1]);
    EXPECT_EQ(solutions[0], solutions[2]);
  }
}

/// Without exchanges the first pivot would be zero.
TEST(SparseSolver, ExchangesRowsWithinAFront) {
  const Matrix m{{0, 2, 4}, {0, 1, 0, 1}, {0, 2, 3, 1}};
  SparseSolver solver(m.start, m.row);
  EXPECT_FALSE(solver.factorise({0, 2, 2, 1}, Factors::ldlt));
  ASSERT_TRUE(solver.factorise(m.values, Factors::lu));
  std::vector<double> x{3, 4};
  ASSERT_TRUE(solver.solve(x));
  EXPECT_NEAR(x[0], 1.5, 1e-15);
  EXPECT_NEAR(x[1], 1, 1e-15);
}

/// Factors in single precision solve to that precision, and precondition GMRES to the precision of the matrix.
TEST(Gmres, RefinesSolutionsInSinglePrecision) {
  Matrix m = make_cube(6, 3);
  for (const auto factors : {Factors::lu, Factors::ldlt}) {
    fill(m, 90, factors == Factors::ldlt, false, 4);
    SparseSolver<float> solver(m.start, m.row);
    ASSERT_TRUE(solver.factorise(m.values, factors));
    const std::vector<double> b = draw_right(m.size());
    std::vector<double> x = b;
    ASSERT_TRUE(solver.solve(x));
    EXPECT_LT(find_residual(m, x, b), 1e-5);
    EXPECT_GT(find_residual(m, x, b), 1e-9);
    const LinearMap apply = [&](std::vector<double>& y) {
      y = m.times(y);
      return true;
    };
    const LinearMap invert = [&](std::vector<double>& y) { return solver.solve(y); };
    EXPECT_LE(solve_by_gmres(apply, invert, b, 1e-13, 4, x), 1e-13);
    EXPECT_LT(find_residual(m, x, b), 1e-12);
  }
}

TEST(Gmres, ReducesTheResidualWithTheFactorsOfAnotherMatrix) {
  Matrix m = make_cube(5, 2);
  SparseSolver solver(m.start, m.row);
  fill(m, 20, false, false, 1);
  ASSERT_TRUE(solver.factorise(m.values, Factors::lu));
  fill(m, 20, false, false, 2);
  const std::vector<double> b = draw_right(m.size());
  const LinearMap apply = [&](std::vector<double>& x) {
    x = m.times(x);
    return true;
  };
  const LinearMap invert = [&](std::vector<double>& x) { return solver.solve(x); };
  std::vector<double> x;
  for (const double tolerance : {0.1, 1e-10}) {
    const double left = solve_by_gmres(apply, invert, b, tolerance, 60, x);
    EXPECT_LE(left, tolerance);
    double residual = 0, size = 0;
    const std::vector<double> product = m.times(x);
    for (std::size_t i = 0; i < b.size(); ++i)
      residual += (product[i] - b[i]) * (product[i] - b[i]), size += b[i] * b[i];
    EXPECT_NEAR(std::sqrt(residual / size), left, 1e-12);
  }
  EXPECT_GT(solve_by_gmres(apply, invert, b, 1e-10, 2, x), 1e-10) << "two iterations do not suffice";
  EXPECT_EQ(solve_by_gmres(apply, invert, std::vector<double>(b.size(), 0.0), 1e-10, 2, x), 0);
  const LinearMap fail = [](std::vector<double>&) { return false; };
  EXPECT_TRUE(std::isinf(solve_by_gmres(apply, fail, b, 0.1, 2, x)));
}

}  // namespace
}  // namespace talus::sparse
