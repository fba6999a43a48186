// SPDX-License-Identifier: MIT
// Ruiz' equilibration (CERFACS report 2001): each row and column divided by the root of its largest entry, again and
// again.

#include "bounds/conic/equilibrate.hpp"

#include <algorithm>
#include <cmath>

namespace talus::bounds {

namespace {

constexpr int sweeps = 10;

double invert_root(double largest) {
  return largest > 0 ? 1 / std::sqrt(largest) : 1;
}

double find_largest(const std::vector<double>& v) {
  double largest = 0;
  for (double x : v) largest = std::max(largest, std::abs(x));
  return largest;
}

/// Rows of one cone share a factor, or the cone would be another one.
void share(const ConicProgram& program, std::vector<double>& largest) {
  std::size_t row = static_cast<std::size_t>(program.equations);
  for (const int size : program.cones) {
    const auto begin = largest.begin() + static_cast<std::ptrdiff_t>(row);
    std::fill(begin, begin + size, *std::max_element(begin, begin + size));
    row += static_cast<std::size_t>(size);
  }
}

}  // namespace

Equilibration equilibrate(ConicProgram& program) {
  SparseRows& a = program.rows;
  const auto rows = static_cast<std::size_t>(a.count()), columns = static_cast<std::size_t>(program.variables);
  Equilibration e{std::vector<double>(rows, 1), std::vector<double>(columns, 1), 1, 1};
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::vector<double> row(rows, 0), column(columns, 0);
    for (std::size_t r = 0; r < rows; ++r)
      for (auto k = static_cast<std::size_t>(a.first[r]); k < static_cast<std::size_t>(a.first[r + 1]); ++k) {
        const double size = std::abs(a.value[k]);
        row[r] = std::max(row[r], size);
        auto& own = column[static_cast<std::size_t>(a.column[k])];
        own = std::max(own, size);
      }
    share(program, row);
    for (double& x : row) x = invert_root(x);
    for (double& x : column) x = invert_root(x);
    for (std::size_t r = 0; r < rows; ++r) {
      e.row[r] *= row[r];
      for (auto k = static_cast<std::size_t>(a.first[r]); k < static_cast<std::size_t>(a.first[r + 1]); ++k)
        a.value[k] *= row[r] * column[static_cast<std::size_t>(a.column[k])];
    }
    for (std::size_t j = 0; j < columns; ++j) e.column[j] *= column[j];
  }
  for (std::size_t r = 0; r < rows; ++r) program.right[r] *= e.row[r];
  for (std::size_t j = 0; j < columns; ++j) program.cost[j] *= e.column[j];
  if (const double largest = find_largest(program.right); largest > 0) e.right = 1 / largest;
  if (const double largest = find_largest(program.cost); largest > 0) e.cost = 1 / largest;
  for (double& x : program.right) x *= e.right;
  for (double& x : program.cost) x *= e.cost;
  return e;
}

}  // namespace talus::bounds
