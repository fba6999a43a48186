// SPDX-License-Identifier: MIT
// Sparse LU and LDLᵀ of Eigen behind one interface; docs/decisions/0021 gives the reasons for the choice.
#include "fem/sparse_solver.hpp"

#include <Eigen/Sparse>
#include <Eigen/SparseLU>
#include <algorithm>

namespace talus::fem {

namespace {

/// Minimum degree ordering of the symmetric pattern, with less fill-in than a column ordering. SparseLU takes the
/// inverse of the permutation of AMDOrdering.
struct MinimumDegree {
  using PermutationType = Eigen::AMDOrdering<int>::PermutationType;
  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& permutation) {
    PermutationType found;
    Eigen::AMDOrdering<int>()(matrix, found);
    permutation = found.inverse();
  }
};

}  // namespace

struct SparseSolver::Library {
  Eigen::SparseMatrix<double> matrix;
  Eigen::SparseLU<Eigen::SparseMatrix<double>, MinimumDegree> lu;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;
  bool lu_analysed = false, ldlt_analysed = false;
  bool symmetric = false;  ///< of the last factorisation
};

SparseSolver::SparseSolver(const std::vector<int>& column_start, const std::vector<int>& row)
    : library_(std::make_unique<Library>()) {
  const int n = static_cast<int>(column_start.size()) - 1;
  auto& m = library_->matrix;
  m.resize(n, n);
  m.resizeNonZeros(static_cast<Eigen::Index>(row.size()));
  std::copy(column_start.begin(), column_start.end(), m.outerIndexPtr());
  std::copy(row.begin(), row.end(), m.innerIndexPtr());
  library_->lu.isSymmetric(true);
  library_->lu.setPivotThreshold(1e-3);
}

SparseSolver::~SparseSolver() = default;
SparseSolver::SparseSolver(SparseSolver&&) noexcept = default;

bool SparseSolver::factorise(const std::vector<double>& values, bool symmetric) {
  Library& l = *library_;
  std::copy(values.begin(), values.end(), l.matrix.valuePtr());
  l.symmetric = symmetric;
  ++factorisations_;
  if (symmetric) {
    if (!l.ldlt_analysed) l.ldlt.analyzePattern(l.matrix);
    l.ldlt_analysed = true;
    l.ldlt.factorize(l.matrix);
    return l.ldlt.info() == Eigen::Success && l.ldlt.vectorD().minCoeff() > 0;
  }
  if (!l.lu_analysed) l.lu.analyzePattern(l.matrix);
  l.lu_analysed = true;
  l.lu.factorize(l.matrix);
  return l.lu.info() == Eigen::Success;
}

bool SparseSolver::solve(const std::vector<double>& b, std::vector<double>& x) {
  Library& l = *library_;
  const Eigen::Map<const Eigen::VectorXd> right(b.data(), static_cast<Eigen::Index>(b.size()));
  const Eigen::VectorXd solution =
      l.symmetric ? Eigen::VectorXd(l.ldlt.solve(right)) : Eigen::VectorXd(l.lu.solve(right));
  if (!solution.allFinite()) return false;
  x.assign(solution.data(), solution.data() + solution.size());
  return true;
}

bool SparseSolver::solve(const std::vector<double>& values, bool symmetric, const std::vector<double>& b,
                         std::vector<double>& x) {
  return factorise(values, symmetric) && solve(b, x);
}

}  // namespace talus::fem
