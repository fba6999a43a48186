// SPDX-License-Identifier: MIT
// The system of the least change, solved again for what it leaves.

#include "bounds/least_change.hpp"

#include <Eigen/SparseCholesky>

namespace talus::bounds {

void fulfil(const SparseRows& a, int rows, const std::vector<double>& right, std::vector<double>& x) {
  constexpr double shift = 1e-10;
  constexpr int most_rounds = 4;
  const int n = static_cast<int>(x.size());
  if (rows == 0) return;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 1.0);
  for (int r = 0; r < rows; ++r) {
    entries.emplace_back(n + r, n + r, -shift);
    for (int k = a.first[static_cast<std::size_t>(r)]; k < a.first[static_cast<std::size_t>(r + 1)]; ++k)
      entries.emplace_back(n + r, a.column[static_cast<std::size_t>(k)], a.value[static_cast<std::size_t>(k)]);
  }
  Eigen::SparseMatrix<double> matrix(n + rows, n + rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors(matrix);
  Eigen::VectorXd left = Eigen::VectorXd::Zero(n + rows);
  for (int round = 0; round < most_rounds; ++round) {
    for (int r = 0; r < rows; ++r) {
      double own = right[static_cast<std::size_t>(r)];
      for (int k = a.first[static_cast<std::size_t>(r)]; k < a.first[static_cast<std::size_t>(r + 1)]; ++k)
        own -=
            a.value[static_cast<std::size_t>(k)] * x[static_cast<std::size_t>(a.column[static_cast<std::size_t>(k)])];
      left[n + r] = own;
    }
    const Eigen::VectorXd change = factors.solve(left);
    for (int i = 0; i < n; ++i) x[static_cast<std::size_t>(i)] += change[i];
  }
}

}  // namespace talus::bounds
