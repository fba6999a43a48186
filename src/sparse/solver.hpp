// SPDX-License-Identifier: MIT
#pragma once
// Direct solution of sparse linear systems with one pattern and varying values, by multifrontal factorisation.

#include <array>
#include <cstddef>
#include <vector>

#include "base/aligned.hpp"
#include "sparse/elimination.hpp"

namespace talus::sparse {

enum class Factors {
  lu,   ///< L U with row exchanges among the pivots of a front
  ldlt  ///< L D Lᵀ of a symmetric matrix, without exchanges: for definite and quasi-definite matrices
};

/// Entries that a pattern has.
enum class Stored {
  all,
  lower  ///< the lower triangle of a symmetric matrix, for L D Lᵀ
};

/// Real: number type of the factors. Single precision halves their memory and the time to read it; its solutions are
/// approximations, for the preconditioning of an iteration. Results are bitwise identical for any number of threads.
template <class Real = double>
class SparseSolver {
 public:
  /// Takes a square pattern by compressed columns with sorted rows; it must be symmetric, or half of
  /// a symmetric one, and contain the diagonal.
  /// `threads`: 0 for all of the machine.
  SparseSolver(const std::vector<int>& column_start, const std::vector<int>& row, int threads = 1,
               Stored stored = Stored::all);

  /// Factorises A, given by its values in the order of the pattern, and keeps the factors; L D Lᵀ reads one of each
  /// pair of symmetric entries. Returns false if a pivot is zero or not finite.
  bool factorise(const std::vector<double>& values, Factors factors);
  /// Number of negative entries of D: that of the negative eigenvalues of A.
  int negative_pivots() const { return negative_pivots_; }
  /// Solves A x = b with the last factors, where `x` holds b before. Returns false if the solution is not finite.
  bool solve(std::vector<double>& x);

  int factorisations() const { return factorisations_; }

 private:
  /// Places of the factors of a front in `lower_` (all rows of the pivots' columns) and `upper_` (the columns of its
  /// other unknowns in the pivots' rows), and of its first value in `order_`.
  struct Place {
    std::size_t lower = 0, upper = 0, value = 0, changes = 0;
    int stack = 0;           ///< where its changes wait
    std::size_t update = 0;  ///< of a right-hand side, in `updates_`
  };
  void place_changes();
  bool eliminate(const std::vector<double>& values, int f, int threads, int thread);
  void add_values(const std::vector<double>& values, int f);
  bool eliminate_ldlt(int f, int threads, int thread);
  bool eliminate_lu(int f, int threads, int thread);
  void add_changes_of_children(int f, int thread);
  void substitute(int f, Real* y, std::vector<Real>& work);
  void substitute_back(int f, Real* y, std::vector<Real>& work) const;
  Real* find_changes(int f, int thread);

  Elimination plan_;
  std::vector<Place> places_;
  std::vector<int> subtrees_;          ///< roots of the subtrees that are factorised side by side
  std::vector<int> tops_;              ///< fronts above them, in postorder
  std::vector<int> order_;             ///< values, by the fronts that they enter
  std::vector<int> slots_;             ///< of each of them: index in the front's `lower_`, or -1 - that in its `upper_`
  AlignedVector<Real> lower_, upper_;  ///< aligned, because Eigen sums in the order of the places in memory
  std::vector<int> exchanged_;         ///< row of its front's pivots that was moved to each pivot
  /// Changes of each front until its parent has added them: two stacks for each thread, and the roots of subtrees.
  std::vector<std::array<AlignedVector<Real>, 2>> stacks_;
  AlignedVector<Real> kept_;
  AlignedVector<Real> updates_;  ///< what the pivots of each front leave to its other rows of a right-hand side
  std::vector<int> negative_;    ///< negative pivots of each front
  Factors factors_ = Factors::lu;
  int threads_ = 1, factorisations_ = 0, negative_pivots_ = 0;
};

}  // namespace talus::sparse
