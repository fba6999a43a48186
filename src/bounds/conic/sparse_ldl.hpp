// SPDX-License-Identifier: MIT
#pragma once
// Supernodal factorisation L D Lᵀ of a sparse symmetric matrix that needs no pivots, such as a quasi-definite one.

#include <cstddef>
#include <span>
#include <vector>

namespace talus::bounds {

/// The lower triangle of a sparse symmetric matrix by columns. Rows increase within a column, and the first one is the
/// diagonal.
struct LowerTriangle {
  int size = 0;
  std::vector<int> first;  ///< index in `row` of the first entry of each column; one more at the end
  std::vector<int> row;
};

/// The multifrontal method (Duff and Reid, ACM Trans. Math. Softw. 9, 1983; Liu, SIAM Rev. 34, 1992), ordered by
/// minimum degree. Columns with the same rows form a supernode, whose front is a dense matrix.
class SparseLdl {
 public:
  /// Orders the unknowns and determines the supernodes of a pattern.
  void analyse(const LowerTriangle& pattern);
  /// Factorises a matrix of the pattern from the values of its entries. Returns false if a factor is not finite.
  bool factorise(std::span<const double> values);
  /// Solves for `columns` right-hand sides in place, one after the other in `x`.
  void solve(double* x, int columns = 1) const;

 private:
  /// Consecutive columns, and the rows below them.
  struct Supernode {
    int first = 0, columns = 0;
    int parent = -1;          ///< −1: a root
    std::size_t rows = 0;     ///< index in `rows_` of the first row below
    int below = 0;            ///< number of rows below
    std::size_t values = 0;   ///< index in `values_` of its columns, (columns + below) values each
    bool has_update = false;  ///< its rows below are not empty
  };
  void order(const LowerTriangle& pattern);
  std::vector<int> count_columns() const;
  void list_supernodes(const std::vector<int>& counts);
  void list_rows();
  void place_entries(const LowerTriangle& pattern);
  void add_update(const Supernode& child, const double* update, double* own, double* front) const;

  int size_ = 0;
  std::vector<int> new_of_, old_of_;      ///< permutation
  std::vector<int> above_first_, above_;  ///< of each new row, the columns left of the diagonal in the matrix
  std::vector<int> parent_;               ///< elimination tree
  std::vector<Supernode> nodes_;
  std::vector<int> node_of_;     ///< supernode of each column
  std::vector<int> rows_;        ///< rows below the supernodes
  std::vector<int> in_parent_;   ///< for each of `rows_`: its position in the front of the parent
  std::vector<std::size_t> at_;  ///< index in `values_` of each entry of the matrix
  std::vector<double> values_;   ///< L below the diagonal, D on it
  std::vector<double> updates_;  ///< stack of the updates of fronts whose parent is not yet factorised
  std::vector<double> scratch_;
  std::size_t largest_stack_ = 0, largest_front_ = 0, largest_panel_ = 0;
};

}  // namespace talus::bounds
