// SPDX-License-Identifier: MIT
#pragma once
// Direct solution of sparse linear systems with one pattern and varying values; the only module that uses the
// libraries.

#include <memory>
#include <vector>

namespace talus::fem {

class SparseSolver {
 public:
  /// Takes a square pattern by compressed columns with sorted rows; it must be symmetric and contain the diagonal.
  SparseSolver(const std::vector<int>& column_start, const std::vector<int>& row);
  ~SparseSolver();
  SparseSolver(SparseSolver&&) noexcept;

  /// Factorises A and keeps the factors. `symmetric`: A is symmetric and positive definite, which is cheaper. Returns
  /// false if A is singular, or not positive definite although `symmetric`.
  bool factorise(const std::vector<double>& values, bool symmetric);
  /// Solves A x = b with the last factors. Returns false if the solution is not finite.
  bool solve(const std::vector<double>& b, std::vector<double>& x);
  /// Factorises and solves.
  bool solve(const std::vector<double>& values, bool symmetric, const std::vector<double>& b, std::vector<double>& x);

  int factorisations() const { return factorisations_; }

 private:
  struct Library;
  std::unique_ptr<Library> library_;
  int factorisations_ = 0;
};

}  // namespace talus::fem
