// SPDX-License-Identifier: MIT
#pragma once
// Order in which a sparse matrix with a symmetric pattern is eliminated, and the fronts of that elimination (symbolic
// factorisation). Duff and Reid (1983) introduced the multifrontal method; Liu (1990) describes elimination trees.

#include <vector>

namespace talus::sparse {

/// Successive rows of a front that are successive in the front of its parent too.
struct Run {
  int from = 0, to = 0, count = 0;  ///< index of the first one among `rows`, and in the parent
};

/// The dense matrix in which a group of unknowns, its pivots, is eliminated: rows and columns of the pivots first, then
/// those of `rows`.
struct Front {
  int first = 0;  ///< first pivot, in the order of elimination
  int pivots = 0;
  std::vector<int> rows;      ///< unknowns that the elimination changes, in the order of elimination, increasing
  int parent = -1;            ///< front to which the changes are added; -1: none
  std::vector<int> children;  ///< fronts with this parent
  int first_of_subtree = 0;   ///< a subtree consists of the fronts from here to its root
  std::vector<Run> runs;      ///< of all `rows`, within the pivots of the parent or beyond them
  double work = 0;            ///< multiplications of LU in the subtree

  int size() const { return pivots + static_cast<int>(rows.size()); }
  /// Returns the index in the front of an unknown in the order of elimination.
  int find(int unknown) const;
};

struct Elimination {
  std::vector<int> position;  ///< position of each unknown in the order of elimination
  std::vector<Front> fronts;  ///< in postorder: children before parents
  double work = 0;            ///< multiplications of LU
};

/// Plans the elimination of a pattern given by compressed columns with sorted rows, which must be symmetric and contain
/// the diagonal. The order is by minimum degree, or by nested dissection where that needs less work.
Elimination plan_elimination(const std::vector<int>& column_start, const std::vector<int>& row);

}  // namespace talus::sparse
