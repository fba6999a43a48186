// SPDX-License-Identifier: MIT
// The system of the least change, solved again for what it leaves.

#include "bounds/least_change.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::bounds {

namespace {

constexpr int most_rounds = 8;
/// Small diagonals in place of the rows' zero: one that is too small has no factors where rows repeat one another.
constexpr double shifts[] = {1e-10, 1e-8, 1e-6};

using Matrix = Eigen::SparseMatrix<double>;

Matrix make_matrix(const SparseRows& a, int rows, const std::vector<double>& weights, double shift) {
  const int n = static_cast<int>(weights.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, weights[static_cast<std::size_t>(i)]);
  for (int r = 0; r < rows; ++r) {
    entries.emplace_back(n + r, n + r, -shift);
    for (std::size_t k = a.begin(r); k < a.begin(r + 1); ++k) entries.emplace_back(n + r, a.column[k], a.value[k]);
  }
  Matrix matrix(n + rows, n + rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// right − A x.
Eigen::VectorXd find_left(const SparseRows& a, int rows, const std::vector<double>& right, const Eigen::VectorXd& x) {
  Eigen::VectorXd left(rows);
  for (int r = 0; r < rows; ++r) {
    double own = right[static_cast<std::size_t>(r)];
    for (std::size_t k = a.begin(r); k < a.begin(r + 1); ++k) own -= a.value[k] * x[a.column[k]];
    left[r] = own;
  }
  return left;
}

}  // namespace

void fulfil(const SparseRows& a, int rows, const std::vector<double>& right, std::vector<double>& x,
            const std::vector<double>& weights) {
  if (rows == 0) return;
  const int n = static_cast<int>(x.size());
  const Eigen::VectorXd start = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
  double least = std::numeric_limits<double>::infinity();
  for (const double shift : shifts) {
    const Eigen::SimplicialLDLT<Matrix, Eigen::Lower> factors(
        make_matrix(a, rows, weights.empty() ? std::vector<double>(x.size(), 1) : weights, shift));
    if (factors.info() != Eigen::Success) continue;
    Eigen::VectorXd at = start;
    for (int round = 0; round <= most_rounds; ++round) {
      const Eigen::VectorXd left = find_left(a, rows, right, at);
      const double most = left.lpNorm<Eigen::Infinity>();
      if (!std::isfinite(most) || most >= least) break;
      least = most;
      std::copy_n(at.data(), n, x.begin());
      Eigen::VectorXd sides = Eigen::VectorXd::Zero(n + rows);
      sides.tail(rows) = left;
      at += factors.solve(sides).head(n);
    }
    constexpr double rounding_of_rows = 1e-12;
    if (least < rounding_of_rows) return;
  }
}

}  // namespace talus::bounds
