// SPDX-License-Identifier: MIT
#pragma once
// A second-order cone program, and what can be said of it: a solution, a proof that there is none, or a sentence.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace talus::bounds {

/// A sparse matrix by rows.
struct SparseRows {
  std::vector<int> first{0};  ///< of each row in `column` and `value`; one more at the end
  std::vector<int> column;    ///< increasing within a row
  std::vector<double> value;

  int count() const { return static_cast<int>(first.size()) - 1; }
  /// Of a row, the place of its first entry; of the one after the last row, the number of entries.
  std::size_t begin(int row) const { return static_cast<std::size_t>(first[static_cast<std::size_t>(row)]); }
  void add(int at, double number) { column.push_back(at), value.push_back(number); }
  void end_row() { first.push_back(static_cast<int>(column.size())); }
};

/// Minimise qᵀx over all x and s with A x + s = b. The first rows are equations (s = 0); then come the cones, row after
/// row: of one row s ≥ 0, of more s₀ ≥ |(s₁, s₂, …)|. Its dual: maximise −bᵀz over Aᵀz + q = 0, the rows of the cones
/// in the same cones.
struct ConicProgram {
  int variables = 0;
  int equations = 0;
  std::vector<int> cones;     ///< rows of each
  std::vector<double> cost;   ///< q
  SparseRows rows;            ///< A
  std::vector<double> right;  ///< b

  /// A row by its entries in any order; those of one variable add up. `entries` is empty afterwards.
  void add_row(std::vector<std::pair<int, double>>& entries, double right_side) {
    std::sort(entries.begin(), entries.end());
    for (std::size_t k = 0; k < entries.size(); ++k) {
      if (k > 0 && entries[k].first == entries[k - 1].first) {
        rows.value.back() += entries[k].second;
      } else {
        rows.add(entries[k].first, entries[k].second);
      }
    }
    entries.clear();
    rows.end_row();
    right.push_back(right_side);
  }
};

enum class ConicEnd {
  solved,      ///< x, s and z to the tolerance
  infeasible,  ///< z proves it: Aᵀz = 0 and bᵀz = −1 with z in the cones, so that no x has A x + s = b
  unbounded,   ///< x proves it: A x + s = 0 and qᵀx = −1 with s in the cones
  stalled      ///< none of them: `why` is a sentence
};

struct ConicSolution {
  ConicEnd end = ConicEnd::stalled;
  std::vector<double> x, s, z;
  double primal = 0, dual = 0;  ///< qᵀx and −bᵀz
  int iterations = 0;
  /// Largest |A x + s − b| over 1 + |b|, largest |Aᵀz + q| over 1 + |q|, and |primal − dual| over 1 + the smaller of
  /// both.
  double primal_residual = 0, dual_residual = 0, gap = 0;
  std::string why;
};

struct ConicOptions {
  double tolerance = 1e-6;   ///< of both residuals and the gap
  double value_size = 1e-3;  ///< of qᵀx in the units of the solver, where it is near zero
  double proof = 1e-8;       ///< of a certificate
  int most_iterations = 100;
};

}  // namespace talus::bounds
