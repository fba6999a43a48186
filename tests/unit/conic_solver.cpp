// SPDX-License-Identifier: MIT
// The solver of cone programs: known optima; infeasible and unbounded programs; and comparison with the method of
// multipliers.

#include "bounds/conic/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/conic_splitting.hpp"

namespace talus::bounds {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void set_rows(ConicProgram& program, const MatrixXd& a) {
  program.rows = {};
  for (int r = 0; r < a.rows(); ++r) {
    for (int j = 0; j < a.cols(); ++j)
      if (a(r, j) != 0) program.rows.add(j, a(r, j));
    program.rows.end_row();
  }
}

std::vector<double> to_list(const VectorXd& v) {
  return {v.data(), v.data() + v.size()};
}
VectorXd to_vector(const std::vector<double>& v) {
  return Eigen::Map<const VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

/// Random numbers, the same ones everywhere.
class Random {
 public:
  explicit Random(int seed) : random_(1 + 7919u * static_cast<unsigned>(seed)) {}
  double draw() { return 2 * (static_cast<double>(random_()) / 2147483647.0) - 1; }
  MatrixXd draw(int rows, int columns, double filled = 1) {
    MatrixXd m = MatrixXd::Zero(rows, columns);
    for (int r = 0; r < rows; ++r)
      for (int j = 0; j < columns; ++j)
        if (const double x = draw(); filled >= 1 || draw() < 2 * filled - 1) m(r, j) = x;
    return m;
  }

 private:
  std::minstd_rand random_;
};

/// Rows of a cone program without numbers: `equations`, and cones of one to four rows.
ConicProgram make_shape(Random& random, int variables, int equations, int cones) {
  ConicProgram p;
  p.variables = variables, p.equations = equations;
  for (int c = 0; c < cones; ++c) p.cones.push_back(1 + static_cast<int>(2 * (1 + random.draw())));
  return p;
}

int count_rows(const ConicProgram& p) {
  int rows = p.equations;
  for (const int size : p.cones) rows += size;
  return rows;
}

/// s and z that are complementary in every cone: both inside with zeros, or on opposite rays.
struct Pair {
  VectorXd s, z;
};

Pair make_pair(const ConicProgram& p, Random& random) {
  const int rows = count_rows(p);
  Pair pair{VectorXd::Zero(rows), random.draw(rows, 1)};
  int row = p.equations;
  for (const int size : p.cones) {
    const double kind = random.draw(), length = 1 + random.draw();
    auto s = pair.s.segment(row, size), z = pair.z.segment(row, size);
    const VectorXd tail = random.draw(size - 1, 1);
    if (size > 1 && kind > 0) {
      s << tail.norm(), tail;
      z << length * tail.norm(), -length * tail;
    } else {
      VectorXd inside(size);
      inside << tail.norm() + 0.1 + length, tail;
      s = kind > -0.5 ? inside : VectorXd::Zero(size).eval();
      z = kind > -0.5 ? VectorXd::Zero(size).eval() : inside;
    }
    row += size;
  }
  return pair;
}

/// Its optimum is known: x solves it with s and z, by construction.
ConicProgram make_solvable(int seed, double filled, VectorXd& x) {
  Random random(seed);
  const int variables = 4 + static_cast<int>(10 * (1 + random.draw()));
  ConicProgram p = make_shape(random, variables, variables / 3, variables);
  MatrixXd a = random.draw(count_rows(p), variables, filled);
  const Pair pair = make_pair(p, random);
  x = random.draw(variables, 1);
  set_rows(p, a);
  p.right = to_list(a * x + pair.s);
  p.cost = to_list(-a.transpose() * pair.z);
  return p;
}

void expect_solves(const ConicProgram& p, const ConicSolution& found, double optimum) {
  ASSERT_EQ(found.end, ConicEnd::solved) << found.why;
  const MatrixXd a = make_dense(p);
  const VectorXd x = to_vector(found.x), s = to_vector(found.s), z = to_vector(found.z);
  const double size = 1 + to_vector(p.right).cwiseAbs().maxCoeff(), cost = 1 + to_vector(p.cost).cwiseAbs().maxCoeff();
  EXPECT_LT((a * x + s - to_vector(p.right)).cwiseAbs().maxCoeff(), 1e-5 * size);
  EXPECT_LT((a.transpose() * z + to_vector(p.cost)).cwiseAbs().maxCoeff(), 1e-5 * cost);
  EXPECT_LT((s - project(p, s)).cwiseAbs().maxCoeff(), 1e-9 * size);
  EXPECT_NEAR(found.primal, optimum, 1e-4 * (1 + std::abs(optimum)));
  EXPECT_NEAR(found.dual, optimum, 1e-4 * (1 + std::abs(optimum)));
}

TEST(ConicSolver, FindsTheOptimumThatAProgramWasMadeWith) {
  for (int seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    VectorXd x;
    const ConicProgram p = make_solvable(seed, seed % 2 ? 1 : 0.4, x);
    expect_solves(p, solve(p, {}), to_vector(p.cost).dot(x));
  }
}

TEST(ConicSolver, AgreesWithAMethodOfAnotherKind) {
  for (int seed = 100; seed < 110; ++seed) {
    SCOPED_TRACE(seed);
    VectorXd x;
    const ConicProgram p = make_solvable(seed, 1, x);
    const ConicSolution found = solve(p, {});
    ASSERT_EQ(found.end, ConicEnd::solved) << found.why;
    const double other = to_vector(p.cost).dot(split(p, 20000));
    EXPECT_NEAR(found.primal, other, 1e-3 * (1 + std::abs(other)));
  }
}

/// Infeasible: a z in the cones with Aᵀz = 0 and bᵀz < 0 exists by construction, and what is found is one.
TEST(ConicSolver, ProvesThatThereIsNoSolution) {
  for (int seed = 200; seed < 230; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    ConicProgram p = make_shape(random, 8, 3, 9);
    const VectorXd z = make_pair(p, random).z;
    MatrixXd a = random.draw(count_rows(p), 8);
    a -= z * (z.transpose() * a) / z.squaredNorm();
    VectorXd b = random.draw(count_rows(p), 1);
    b -= z * ((z.dot(b) + 1) / z.squaredNorm());
    set_rows(p, a);
    p.right = to_list(b), p.cost = to_list(a.transpose() * random.draw(count_rows(p), 1));
    const ConicSolution found = solve(p, {});
    ASSERT_EQ(found.end, ConicEnd::infeasible) << found.why;
    const VectorXd proof = to_vector(found.z);
    EXPECT_NEAR(b.dot(proof), -1, 1e-9);
    EXPECT_LT((a.transpose() * proof).cwiseAbs().maxCoeff(), 1e-5);
    const VectorXd inside = project(p, proof);
    EXPECT_LT((proof - inside).tail(count_rows(p) - 3).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(ConicSolver, ProvesThatThereIsNoEnd) {
  for (int seed = 300; seed < 330; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    ConicProgram p = make_shape(random, 8, 3, 9);
    // A d + s = 0 along d = e₁, on which the cost falls, with an s inside the cones; x = 0 is feasible.
    MatrixXd a = random.draw(count_rows(p), 8);
    VectorXd b = VectorXd::Zero(count_rows(p)), s0 = random.draw(count_rows(p), 1);
    s0.head(p.equations).setZero();
    int row = p.equations;
    for (const int size : p.cones) {
      b[row] = 1;
      s0[row] = 0.1 + s0.segment(row + 1, size - 1).norm();
      row += size;
    }
    a.col(0) = -s0;
    set_rows(p, a);
    p.right = to_list(b), p.cost = to_list(random.draw(8, 1));
    p.cost[0] = -1;
    const ConicSolution found = solve(p, {});
    ASSERT_EQ(found.end, ConicEnd::unbounded) << found.why;
    const VectorXd x = to_vector(found.x);
    EXPECT_NEAR(to_vector(p.cost).dot(x), -1, 1e-9);
    const VectorXd s = -a * x;
    EXPECT_LT((s - project(p, s)).cwiseAbs().maxCoeff(), 1e-5);
  }
}

/// The nearest point of a plane nᵀx = d to the origin lies at |d|/|n|; of a line the same in three dimensions.
TEST(ConicSolver, DistanceOfAPlane) {
  ConicProgram p;
  p.variables = 4, p.equations = 1, p.cones = {4};
  p.rows.add(1, 1), p.rows.add(2, -2), p.rows.add(3, 2), p.rows.end_row();
  for (int i = 0; i < 4; ++i) p.rows.add(i, -1), p.rows.end_row();
  p.right = {6, 0, 0, 0, 0}, p.cost = {1, 0, 0, 0};
  expect_solves(p, solve(p, {}), 2);
}

/// Fermat's point of an equilateral triangle of side 1: the sum of distances is √3.
TEST(ConicSolver, FermatsPoint) {
  ConicProgram p;
  p.variables = 5;
  p.cost = {0, 0, 1, 1, 1};
  const double h = 0.5 * std::numbers::sqrt3, corners[3][2] = {{0, 0}, {1, 0}, {0.5, h}};
  for (int i = 0; i < 3; ++i) {
    p.cones.push_back(3);
    p.rows.add(2 + i, -1), p.rows.end_row(), p.right.push_back(0);
    for (int d = 0; d < 2; ++d) p.rows.add(d, -1), p.rows.end_row(), p.right.push_back(-corners[i][d]);
  }
  expect_solves(p, solve(p, {}), std::numbers::sqrt3);
}

/// Rows and columns that differ by twelve orders change neither the optimum nor the number of iterations much.
TEST(ConicSolver, BadlyScaledDataChangeLittle) {
  for (int seed = 400; seed < 410; ++seed) {
    SCOPED_TRACE(seed);
    VectorXd x;
    const ConicProgram p = make_solvable(seed, 1, x);
    const ConicSolution plain = solve(p, {});
    Random random(seed);
    MatrixXd a = make_dense(p);
    VectorXd b = to_vector(p.right), q = to_vector(p.cost);
    for (int j = 0; j < p.variables; ++j) {
      const double by = std::pow(10.0, 3 * random.draw());
      a.col(j) *= by, q[j] *= by;
    }
    int row = 0;
    auto scale_rows = [&](int rows) {
      const double by = std::pow(10.0, 3 * random.draw());
      a.middleRows(row, rows) *= by, b.segment(row, rows) *= by, row += rows;
    };
    for (int r = 0; r < p.equations; ++r) scale_rows(1);
    for (const int size : p.cones) scale_rows(size);
    ConicProgram scaled = p;
    set_rows(scaled, a);
    scaled.right = to_list(1e3 * b), scaled.cost = to_list(1e-4 * q);
    const ConicSolution found = solve(scaled, {});
    ASSERT_EQ(found.end, ConicEnd::solved) << found.why;
    EXPECT_NEAR(found.primal / 0.1, plain.primal, 1e-4 * (1 + std::abs(plain.primal)));
    EXPECT_LE(found.iterations, plain.iterations + 15);
  }
}

/// A warm start from a similar program needs fewer iterations and gives the same solution.
TEST(ConicSolver, BeginsFromANearSolution) {
  int anew = 0, near = 0;
  for (int seed = 500; seed < 520; ++seed) {
    SCOPED_TRACE(seed);
    VectorXd x;
    ConicProgram p = make_solvable(seed, 1, x);
    const ConicSolution first = solve(p, {});
    for (double& b : p.right) b *= 1.001;
    const ConicSolution cold = solve(p, {}), warm = solve(p, {}, &first);
    ASSERT_EQ(warm.end, ConicEnd::solved) << warm.why;
    EXPECT_NEAR(warm.primal, cold.primal, 1e-4 * (1 + std::abs(cold.primal)));
    anew += cold.iterations, near += warm.iterations;
  }
  EXPECT_LT(near, anew);
}

/// A repeated equation, and a variable without equation and cost.
TEST(ConicSolver, RepeatedEquationsAndIdleVariables) {
  ConicProgram p;
  p.variables = 5, p.equations = 2, p.cones = {4};
  for (int i = 0; i < 2; ++i) p.rows.add(1, 1), p.rows.add(2, -2), p.rows.add(3, 2), p.rows.end_row();
  for (int i = 0; i < 4; ++i) p.rows.add(i, -1), p.rows.end_row();
  p.right = {6, 6, 0, 0, 0, 0}, p.cost = {1, 0, 0, 0, 0};
  expect_solves(p, solve(p, {}), 2);
}

}  // namespace
}  // namespace talus::bounds
