// SPDX-License-Identifier: MIT
// Elimination tree, supernodes, dense kernels of the fronts, and the triangular solves.
#include "bounds/conic/sparse_ldl.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace talus::bounds {

namespace {

/// A supernode is merged with its parent if the zeros that this stores are at most this fraction of its values, for
/// narrow ones of up to so many columns together.
constexpr std::pair<int, double> merges[] = {{4, 1}, {16, 0.4}, {48, 0.1}, {1 << 30, 0.05}};
/// Columns of a block in the factorisation of a front.
constexpr int block = 32;

typedef double Row8 __attribute__((vector_size(64), aligned(8), may_alias));

Row8 load(const double* at) {
  return *reinterpret_cast<const Row8*>(at);
}

/// Subtracts A Bᵀ from the lower part of C, by tiles of `Rows` × 4, for A of m rows and B of n rows with k columns
/// each. Tiles above the diagonal, and rows of C from `limit` on, are not changed. Column strides: c, a, b.
template <int Packs>
inline __attribute__((always_inline)) void subtract_tile(double* to, int c, const double* left, int a,
                                                         const double* right, int b, int k) {
  Row8 sum[4][Packs];
  for (int j = 0; j < 4; ++j)
    for (int p = 0; p < Packs; ++p) sum[j][p] = load(to + static_cast<std::ptrdiff_t>(j) * c + 8 * p);
  for (int l = 0; l < k; ++l) {
    Row8 row[Packs];
    for (int p = 0; p < Packs; ++p) row[p] = load(left + static_cast<std::ptrdiff_t>(l) * a + 8 * p);
    for (int j = 0; j < 4; ++j) {
      const double factor = right[static_cast<std::ptrdiff_t>(l) * b + j];
      for (int p = 0; p < Packs; ++p) sum[j][p] -= row[p] * factor;
    }
  }
  for (int j = 0; j < 4; ++j)
    for (int p = 0; p < Packs; ++p)
      *reinterpret_cast<Row8*>(to + static_cast<std::ptrdiff_t>(j) * c + 8 * p) = sum[j][p];
}

/// Subtracts A Bᵀ from the lower trapezium of C (m × n, from the diagonal down), for A (m × k) and B (n × k) by
/// columns.
void subtract_product(double* to, int c, const double* left, int a, const double* right, int b, int m, int n, int k) {
  const auto at = [](std::ptrdiff_t column, int stride, int row) { return column * stride + row; };
  int j = 0;
  for (; j + 4 <= n; j += 4) {
    int i = j;
    for (; i + 16 <= m; i += 16) subtract_tile<2>(to + at(j, c, i), c, left + i, a, right + j, b, k);
    if (i + 8 <= m) subtract_tile<1>(to + at(j, c, i), c, left + i, a, right + j, b, k), i += 8;
    for (int column = j; i < m && column < j + 4; ++column)
      for (int l = 0; l < k; ++l) {
        const double factor = right[at(l, b, column)];
        for (int row = i; row < m; ++row) to[at(column, c, row)] -= left[at(l, a, row)] * factor;
      }
  }
  for (; j < n; ++j)
    for (int l = 0; l < k; ++l) {
      const double factor = right[at(l, b, j)];
      for (int row = j; row < m; ++row) to[at(j, c, row)] -= left[at(l, a, row)] * factor;
    }
}

/// Returns the sum of the products of n pairs.
double multiply(const double* a, const double* b, int n) {
  Row8 sums{};
  int i = 0;
  for (; i + 8 <= n; i += 8) sums += load(a + i) * load(b + i);
  double sum = 0;
  for (; i < n; ++i) sum += a[i] * b[i];
  for (int l = 0; l < 8; ++l) sum += sums[l];
  return sum;
}

/// Factorises the first n columns of a front with m rows, and writes their products with D to `scaled` (m × n).
void factorise_columns(double* front, int m, int n, double* scaled) {
  const auto column = [&](double* of, int j) { return of + static_cast<std::ptrdiff_t>(j) * m; };
  for (int begin = 0; begin < n; begin += block) {
    const int end = std::min(n, begin + block);
    for (int j = begin; j < end; ++j) {
      double *own = column(front, j), *product = column(scaled, j);
      const double inverse = 1 / own[j];
      for (int i = j + 1; i < m; ++i) product[i] = own[i], own[i] *= inverse;
      for (int k = j + 1; k < end; ++k) {
        double* other = column(front, k);
        const double factor = product[k];
        for (int i = k; i < m; ++i) other[i] -= own[i] * factor;
      }
    }
    if (end < n)
      subtract_product(column(front, end) + end, m, column(front, begin) + end, m, column(scaled, begin) + end, m,
                       m - end, n - end, end - begin);
  }
}

}  // namespace

void SparseLdl::analyse(const LowerTriangle& pattern) {
  size_ = pattern.size;
  order(pattern);
  const std::vector<int> counts = count_columns();
  list_supernodes(counts);
  list_rows();
  place_entries(pattern);
}

/// Orders by minimum degree and then by a postorder of the elimination tree.
void SparseLdl::order(const LowerTriangle& pattern) {
  const auto n = static_cast<std::size_t>(size_);
  using Pattern = Eigen::SparseMatrix<double>;
  const std::vector<double> ones(pattern.row.size(), 1);
  const Eigen::Map<const Pattern> lower(size_, size_, static_cast<Eigen::Index>(pattern.row.size()),
                                        pattern.first.data(), pattern.row.data(), ones.data());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> found;
  const Pattern whole = lower.selfadjointView<Eigen::Lower>();
  Eigen::AMDOrdering<int>()(whole, found);
  old_of_.assign(found.indices().data(), found.indices().data() + size_);
  for (int round = 0; round < 2; ++round) {
    new_of_.resize(n);
    for (std::size_t k = 0; k < n; ++k) new_of_[static_cast<std::size_t>(old_of_[k])] = static_cast<int>(k);
    above_first_.assign(n + 1, 0);
    const auto visit = [&](auto use) {
      for (int j = 0; j < size_; ++j)
        for (int k = pattern.first[static_cast<std::size_t>(j)] + 1; k < pattern.first[static_cast<std::size_t>(j) + 1];
             ++k) {
          const auto [low, high] =
              std::minmax(new_of_[static_cast<std::size_t>(j)],
                          new_of_[static_cast<std::size_t>(pattern.row[static_cast<std::size_t>(k)])]);
          use(low, static_cast<std::size_t>(high));
        }
    };
    visit([&](int, std::size_t high) { ++above_first_[high + 1]; });
    std::partial_sum(above_first_.begin(), above_first_.end(), above_first_.begin());
    above_.resize(static_cast<std::size_t>(above_first_.back()));
    std::vector<int> next(above_first_.begin(), above_first_.end() - 1);
    visit([&](int low, std::size_t high) { above_[static_cast<std::size_t>(next[high]++)] = low; });
    // Liu's algorithm with compressed paths.
    parent_.assign(n, -1);
    std::vector<int> top(n, -1);
    for (int i = 0; i < size_; ++i)
      for (int k = above_first_[static_cast<std::size_t>(i)]; k < above_first_[static_cast<std::size_t>(i) + 1]; ++k) {
        int j = above_[static_cast<std::size_t>(k)];
        while (j != -1 && j < i) {
          const int up = std::exchange(top[static_cast<std::size_t>(j)], i);
          if (up == -1) parent_[static_cast<std::size_t>(j)] = i;
          j = up;
        }
      }
    if (round == 1) break;
    // Postorder: children before their parent, each subtree consecutive.
    std::vector<int> child(n, -1), sibling(n, -1), stack, sequence;
    for (int j = size_; j-- > 0;)
      if (const int p = parent_[static_cast<std::size_t>(j)]; p >= 0)
        sibling[static_cast<std::size_t>(j)] = std::exchange(child[static_cast<std::size_t>(p)], j);
    for (int root = 0; root < size_; ++root) {
      if (parent_[static_cast<std::size_t>(root)] >= 0) continue;
      stack.push_back(root);
      while (!stack.empty()) {
        const auto j = static_cast<std::size_t>(stack.back());
        if (const int c = child[j]; c >= 0) {
          child[j] = sibling[static_cast<std::size_t>(c)];
          stack.push_back(c);
        } else {
          sequence.push_back(old_of_[j]);
          stack.pop_back();
        }
      }
    }
    old_of_ = std::move(sequence);
  }
}

/// Returns the number of entries of each column of L, with the diagonal.
std::vector<int> SparseLdl::count_columns() const {
  std::vector<int> counts(static_cast<std::size_t>(size_), 1), mark(static_cast<std::size_t>(size_), -1);
  for (int i = 0; i < size_; ++i) {
    mark[static_cast<std::size_t>(i)] = i;
    for (int k = above_first_[static_cast<std::size_t>(i)]; k < above_first_[static_cast<std::size_t>(i) + 1]; ++k)
      for (auto j = static_cast<std::size_t>(above_[static_cast<std::size_t>(k)]); mark[j] != i;
           j = static_cast<std::size_t>(parent_[j])) {
        mark[j] = i;
        ++counts[j];
      }
  }
  return counts;
}

void SparseLdl::list_supernodes(const std::vector<int>& counts) {
  nodes_.clear();
  for (int j = 0; j < size_; ++j) {
    const auto own = static_cast<std::size_t>(j);
    if (j > 0 && parent_[own - 1] == j && counts[own - 1] == counts[own] + 1) {
      ++nodes_.back().columns;
      nodes_.back().below = counts[own] - 1;
    } else {
      nodes_.push_back({j, 1, -1, 0, counts[own] - 1, 0, false});
    }
    // Merges supernodes that end here with the preceding ones, which are their last children.
    const bool ends = j + 1 == size_ || parent_[own] != j + 1 || counts[own] != counts[own + 1] + 1;
    while (ends && nodes_.size() > 1) {
      const Supernode &child = nodes_[nodes_.size() - 2], &last = nodes_.back();
      if (parent_[static_cast<std::size_t>(child.first + child.columns - 1)] != last.first) break;
      const int columns = child.columns + last.columns;
      const double zeros = static_cast<double>(child.columns) * (last.columns + last.below - child.below);
      const auto limit =
          std::find_if(std::begin(merges), std::end(merges), [&](const auto& m) { return columns <= m.first; });
      if (zeros > limit->second * columns * (0.5 * columns + last.below)) break;
      const int below = last.below;
      nodes_.pop_back();
      nodes_.back().columns = columns, nodes_.back().below = below;
    }
  }
  node_of_.resize(static_cast<std::size_t>(size_));
  for (std::size_t s = 0; s < nodes_.size(); ++s)
    std::fill_n(node_of_.begin() + nodes_[s].first, nodes_[s].columns, static_cast<int>(s));
}

void SparseLdl::list_rows() {
  // Columns of the matrix by supernode, downwards.
  std::vector<int> first(nodes_.size() + 1, 0);
  const auto visit = [&](auto use) {
    for (int i = 0; i < size_; ++i)
      for (int k = above_first_[static_cast<std::size_t>(i)]; k < above_first_[static_cast<std::size_t>(i) + 1]; ++k)
        use(static_cast<std::size_t>(node_of_[static_cast<std::size_t>(above_[static_cast<std::size_t>(k)])]), i);
  };
  visit([&](std::size_t s, int) { ++first[s + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> entries(static_cast<std::size_t>(first.back())), next(first.begin(), first.end() - 1);
  visit([&](std::size_t s, int i) { entries[static_cast<std::size_t>(next[s]++)] = i; });

  std::vector<int> mark(static_cast<std::size_t>(size_), -1), place(static_cast<std::size_t>(size_));
  std::vector<std::vector<std::size_t>> children(nodes_.size());
  rows_.clear();
  std::size_t values = 0, stack = 0;
  largest_stack_ = largest_front_ = largest_panel_ = 0;
  for (std::size_t s = 0; s < nodes_.size(); ++s) {
    Supernode& node = nodes_[s];
    const int end = node.first + node.columns;
    node.rows = rows_.size();
    const auto add = [&](int i) {
      if (i >= end && std::exchange(mark[static_cast<std::size_t>(i)], static_cast<int>(s)) != static_cast<int>(s))
        rows_.push_back(i);
    };
    for (int k = first[s]; k < first[s + 1]; ++k) add(entries[static_cast<std::size_t>(k)]);
    for (const std::size_t c : children[s])
      for (int k = 0; k < nodes_[c].below; ++k) add(rows_[nodes_[c].rows + static_cast<std::size_t>(k)]);
    std::sort(rows_.begin() + static_cast<std::ptrdiff_t>(node.rows), rows_.end());
    node.below = static_cast<int>(rows_.size() - node.rows);
    node.has_update = node.below > 0;
    node.values = values;
    const auto columns = static_cast<std::size_t>(node.columns), below = static_cast<std::size_t>(node.below);
    values += columns * (columns + below);
    largest_panel_ = std::max(largest_panel_, columns * (columns + below));
    largest_front_ = std::max(largest_front_, below * below);
    // Positions of the rows of the children.
    for (std::size_t k = 0; k < columns; ++k) place[static_cast<std::size_t>(node.first) + k] = static_cast<int>(k);
    for (std::size_t k = 0; k < below; ++k)
      place[static_cast<std::size_t>(rows_[node.rows + k])] = static_cast<int>(columns + k);
    in_parent_.resize(rows_.size());
    for (const std::size_t c : children[s]) {
      const auto count = static_cast<std::size_t>(nodes_[c].below);
      for (std::size_t k = 0; k < count; ++k)
        in_parent_[nodes_[c].rows + k] = place[static_cast<std::size_t>(rows_[nodes_[c].rows + k])];
      stack -= count * count;
    }
    stack += below * below;
    largest_stack_ = std::max(largest_stack_, stack);
    if (node.has_update) {
      node.parent = node_of_[static_cast<std::size_t>(rows_[node.rows])];
      children[static_cast<std::size_t>(node.parent)].push_back(s);
    }
  }
  values_.resize(values);
}

void SparseLdl::place_entries(const LowerTriangle& pattern) {
  at_.resize(pattern.row.size());
  for (int j = 0; j < size_; ++j)
    for (auto k = static_cast<std::size_t>(pattern.first[static_cast<std::size_t>(j)]);
         k < static_cast<std::size_t>(pattern.first[static_cast<std::size_t>(j) + 1]); ++k) {
      const auto [low, high] =
          std::minmax(new_of_[static_cast<std::size_t>(j)], new_of_[static_cast<std::size_t>(pattern.row[k])]);
      const Supernode& node = nodes_[static_cast<std::size_t>(node_of_[static_cast<std::size_t>(low)])];
      int row = high - node.first;
      if (row >= node.columns) {
        const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(node.rows);
        row = node.columns + static_cast<int>(std::lower_bound(begin, begin + node.below, high) - begin);
      }
      at_[k] = node.values +
               static_cast<std::size_t>(low - node.first) * static_cast<std::size_t>(node.columns + node.below) +
               static_cast<std::size_t>(row);
    }
}

/// Adds the update of a child (lower triangle by columns) to the columns of its parent and to the parent's own update.
void SparseLdl::add_update(const Supernode& child, const double* update, double* own, double* front) const {
  const Supernode& node = nodes_[static_cast<std::size_t>(child.parent)];
  const int* to = in_parent_.data() + child.rows;
  const std::ptrdiff_t rows = node.columns + node.below;
  for (std::ptrdiff_t j = 0; j < child.below; ++j) {
    const double* column = update + j * child.below;
    double* into = to[j] < node.columns
                       ? own + to[j] * rows
                       : front + static_cast<std::ptrdiff_t>(to[j] - node.columns) * node.below - node.columns;
    for (std::ptrdiff_t i = j; i < child.below; ++i) into[to[i]] += column[i];
  }
}

bool SparseLdl::factorise(std::span<const double> values) {
  std::fill(values_.begin(), values_.end(), 0.0);
  for (std::size_t k = 0; k < at_.size(); ++k) values_[at_[k]] += values[k];
  updates_.resize(largest_stack_ + largest_front_);
  scratch_.resize(largest_front_ + largest_panel_);
  double *front = scratch_.data(), *scaled = front + largest_front_;
  std::size_t top = 0;
  std::vector<std::size_t> pending;  // supernodes on the stack
  for (std::size_t s = 0; s < nodes_.size(); ++s) {
    const Supernode& node = nodes_[s];
    double* own = &values_[node.values];
    const std::size_t below = static_cast<std::size_t>(node.below);
    const int rows = node.columns + node.below;
    std::fill_n(front, below * below, 0.0);
    while (!pending.empty() && nodes_[pending.back()].parent == static_cast<int>(s)) {
      const Supernode& child = nodes_[pending.back()];
      top -= static_cast<std::size_t>(child.below) * static_cast<std::size_t>(child.below);
      add_update(child, updates_.data() + top, own, front);
      pending.pop_back();
    }
    factorise_columns(own, rows, node.columns, scaled);
    for (int j = 0; j < node.columns; ++j)
      if (!std::isfinite(own[static_cast<std::ptrdiff_t>(j) * rows + j]) ||
          own[static_cast<std::ptrdiff_t>(j) * rows + j] == 0)
        return false;
    if (node.below == 0) continue;
    subtract_product(front, node.below, own + node.columns, rows, scaled + node.columns, rows, node.below, node.below,
                     node.columns);
    std::copy_n(front, below * below, updates_.data() + top);
    top += below * below;
    pending.push_back(s);
  }
  return true;
}

void SparseLdl::solve(double* x, int columns) const {
  std::vector<double> y(static_cast<std::size_t>(size_)), part;
  for (int c = 0; c < columns; ++c) {
    double* own = x + static_cast<std::ptrdiff_t>(c) * size_;
    for (std::size_t k = 0; k < y.size(); ++k) y[k] = own[old_of_[k]];
    for (const Supernode& node : nodes_) {
      const int* rows = rows_.data() + node.rows;
      const std::ptrdiff_t stride = node.columns + node.below;
      double* at = &y[static_cast<std::size_t>(node.first)];
      part.assign(static_cast<std::size_t>(node.below), 0);
      for (int j = 0; j < node.columns; ++j) {
        const double *column = &values_[node.values] + j * stride, factor = at[j];
        for (int i = j + 1; i < node.columns; ++i) at[i] -= column[i] * factor;
        for (int i = 0; i < node.below; ++i) part[static_cast<std::size_t>(i)] += column[node.columns + i] * factor;
      }
      for (int i = 0; i < node.below; ++i) y[static_cast<std::size_t>(rows[i])] -= part[static_cast<std::size_t>(i)];
    }
    for (std::size_t s = nodes_.size(); s-- > 0;) {
      const Supernode& node = nodes_[s];
      const int* rows = rows_.data() + node.rows;
      const std::ptrdiff_t stride = node.columns + node.below;
      double* at = &y[static_cast<std::size_t>(node.first)];
      part.resize(static_cast<std::size_t>(node.below));
      for (int i = 0; i < node.below; ++i) part[static_cast<std::size_t>(i)] = y[static_cast<std::size_t>(rows[i])];
      for (int j = node.columns; j-- > 0;) {
        const double* column = &values_[node.values] + j * stride;
        at[j] = at[j] / column[j] - multiply(column + j + 1, at + j + 1, node.columns - j - 1) -
                multiply(column + node.columns, part.data(), node.below);
      }
    }
    for (std::size_t k = 0; k < y.size(); ++k) own[old_of_[k]] = y[k];
  }
}

}  // namespace talus::bounds
