// SPDX-License-Identifier: MIT
#include "sparse/solver.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/parallel.hpp"

namespace talus::sparse {
namespace {

using Stride = Eigen::OuterStride<>;
template <class Real>
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
template <class Real>
using Column = Eigen::Map<Eigen::Matrix<Real, Eigen::Dynamic, 1>>;
template <class Real>
using Block = Eigen::Map<Matrix<Real>, 0, Stride>;
template <class Real>
using ConstBlock = Eigen::Map<const Matrix<Real>, 0, Stride>;

constexpr int small_block = 16;  ///< pivots that are eliminated one by one
constexpr int chunk = 128;       ///< columns of a product that are one piece of work
constexpr int kept = 2;          ///< place of the changes of the roots of subtrees, beside the two stacks

/// Factorises the lower triangle of a block as L D Lᵀ without exchanges; D replaces the diagonal of ones. Returns false
/// if a pivot is zero or not finite.
template <class Real>
bool factorise_ldlt(Eigen::Ref<Matrix<Real>, 0, Stride> a) {
  const Eigen::Index n = a.rows();
  if (n <= small_block) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const Real pivot = a(k, k);
      if (pivot == 0 || !std::isfinite(pivot)) return false;
      for (Eigen::Index j = k + 1; j < n; ++j) {
        const Real factor = a(j, k) / pivot;
        for (Eigen::Index i = j; i < n; ++i) a(i, j) -= a(i, k) * factor;
      }
      for (Eigen::Index i = k + 1; i < n; ++i) a(i, k) /= pivot;
    }
    return true;
  }
  const Eigen::Index h = n / 2, rest = n - h;
  if (!factorise_ldlt<Real>(a.topLeftCorner(h, h))) return false;
  auto below = a.bottomLeftCorner(rest, h);
  a.topLeftCorner(h, h)
      .template triangularView<Eigen::UnitLower>()
      .transpose()
      .template solveInPlace<Eigen::OnTheRight>(below);
  const Matrix<Real> scaled = below;  // L D
  below = scaled * a.diagonal().head(h).cwiseInverse().asDiagonal();
  a.bottomRightCorner(rest, rest).template triangularView<Eigen::Lower>() -= scaled * below.transpose();
  return factorise_ldlt<Real>(a.bottomRightCorner(rest, rest));
}

struct Pattern {
  std::vector<int> column_start{0}, row;
};

/// Returns the whole pattern of a symmetric matrix from its lower triangle.
Pattern complete(const std::vector<int>& column_start, const std::vector<int>& row) {
  const int n = static_cast<int>(column_start.size()) - 1;
  std::vector<int> next(column_start.size(), 0);
  for (int j = 0; j < n; ++j)
    for (int k = column_start[j]; k < column_start[j + 1]; ++k) ++next[j], next[row[k]] += row[k] != j;
  Pattern whole;
  for (int j = 0; j < n; ++j) whole.column_start.push_back(whole.column_start.back() + next[j]);
  whole.row.resize(static_cast<std::size_t>(whole.column_start.back()));
  std::copy(whole.column_start.begin(), whole.column_start.end(), next.begin());
  for (int j = 0; j < n; ++j)  // columns in order, so that the rows above the diagonal increase
    for (int k = column_start[j]; k < column_start[j + 1]; ++k) {
      whole.row[next[j]++] = row[k];
      if (row[k] != j) whole.row[next[row[k]]++] = j;
    }
  return whole;
}

Elimination plan_stored(const std::vector<int>& column_start, const std::vector<int>& row, Stored stored) {
  if (stored == Stored::all) return plan_elimination(column_start, row);
  const Pattern whole = complete(column_start, row);
  return plan_elimination(whole.column_start, whole.row);
}

/// Fronts in subtrees that are factorised side by side, the largest first, and fronts above them in postorder.
struct Division {
  std::vector<int> subtrees, tops;
};

/// Divides the fronts so that no subtree has more than a share of the work.
Division divide(const Elimination& plan, double share) {
  Division division;
  for (int f = static_cast<int>(plan.fronts.size()) - 1; f >= 0;) {
    const Front& front = plan.fronts[f];
    const bool is_small = front.work <= share * plan.work * (1 + 1e-9);
    (is_small ? division.subtrees : division.tops).push_back(f);
    f = is_small ? front.first_of_subtree - 1 : f - 1;
  }
  std::reverse(division.tops.begin(), division.tops.end());
  // The largest ones first, so that no thread ends long after the others.
  std::stable_sort(division.subtrees.begin(), division.subtrees.end(),
                   [&](int a, int b) { return plan.fronts[a].work > plan.fronts[b].work; });
  return division;
}

/// Returns the work of the thread that ends last, and that of the fronts above the subtrees.
double estimate_time(const Elimination& plan, const Division& division, int threads) {
  std::vector<double> busy(static_cast<std::size_t>(threads), 0);
  double in_subtrees = 0;
  for (const int root : division.subtrees) {
    *std::min_element(busy.begin(), busy.end()) += plan.fronts[root].work;
    in_subtrees += plan.fronts[root].work;
  }
  return *std::max_element(busy.begin(), busy.end()) + plan.work - in_subtrees;
}

}  // namespace

template <class Real>
SparseSolver<Real>::SparseSolver(const std::vector<int>& column_start, const std::vector<int>& row, int threads,
                                 Stored stored)
    : plan_(plan_stored(column_start, row, stored)), threads_(threads > 0 ? threads : default_threads()) {
  stacks_.resize(static_cast<std::size_t>(threads_));
  std::size_t lower = 0, upper = 0, update = 0;
  std::vector<int> front_of(plan_.position.size());
  for (std::size_t f = 0; f < plan_.fronts.size(); ++f) {
    const Front& front = plan_.fronts[f];
    places_.push_back({lower, upper});
    places_.back().update = update;
    update += (front.rows.size() + 15) / 16 * 16;  // so that no two threads write one cache line
    lower += static_cast<std::size_t>(front.size()) * static_cast<std::size_t>(front.pivots);
    if (stored == Stored::all) upper += front.rows.size() * static_cast<std::size_t>(front.pivots);
    std::fill_n(front_of.begin() + front.first, front.pivots, static_cast<int>(f));
  }
  lower_.resize(lower);
  upper_.resize(upper);
  updates_.resize(update);
  exchanged_.resize(plan_.position.size());
  negative_.resize(plan_.fronts.size());
  std::vector<std::vector<std::array<int, 2>>> entries(plan_.fronts.size());  // of each front: value and slot
  for (std::size_t j = 0; j + 1 < column_start.size(); ++j)
    for (int k = column_start[j]; k < column_start[j + 1]; ++k) {
      int r = plan_.position[row[k]], c = plan_.position[j];
      if (stored == Stored::lower && r < c) std::swap(r, c);
      const int f = front_of[std::min(r, c)];
      const Front& front = plan_.fronts[f];
      const int in_row = front.find(r), in_column = front.find(c);
      entries[f].push_back({k, in_column < front.pivots ? in_row + in_column * front.size()
                                                        : -1 - in_row - (in_column - front.pivots) * front.pivots});
    }
  for (std::size_t f = 0; f < plan_.fronts.size(); ++f) {
    places_[f].value = order_.size();
    for (const auto& [value, slot] : entries[f]) order_.push_back(value), slots_.push_back(slot);
  }
  places_.push_back({lower, upper, order_.size()});
  double least = std::numeric_limits<double>::infinity();
  for (const double share : {1.0, 0.7, 0.5, 0.35, 0.25, 0.17, 0.12, 0.08, 0.06, 0.04, 0.03, 0.02}) {
    Division tried = divide(plan_, share);
    const double time = estimate_time(plan_, tried, threads_);
    if (time < least * (1 - 1e-9)) least = time, subtrees_ = std::move(tried.subtrees), tops_ = std::move(tried.tops);
  }
  place_changes();
}

/// Plans where the changes of each front wait until its parent has added them. In postorder, the fronts of one level
/// whose changes wait are added last in, first out, so two stacks suffice: for even and for odd levels.
template <class Real>
void SparseSolver<Real>::place_changes() {
  std::vector<int> level(plan_.fronts.size(), 0);
  for (std::size_t f = plan_.fronts.size(); f-- > 0;)
    for (const int child : plan_.fronts[f].children) level[child] = 1 - level[f];
  std::array<std::size_t, 3> top{}, most{};
  const auto put = [&](int f, int stack) {
    const std::size_t count = plan_.fronts[f].rows.size();
    places_[f].changes = top[stack];
    places_[f].stack = stack;
    top[stack] += (count * count + 15) / 16 * 16;  // so that every start is aligned
    most[stack] = std::max(most[stack], top[stack]);
    for (const int child : plan_.fronts[f].children)
      if (places_[child].stack == 1 - stack) top[1 - stack] = std::min(top[1 - stack], places_[child].changes);
  };
  for (const int root : subtrees_) {
    top[0] = top[1] = 0;
    for (int f = plan_.fronts[root].first_of_subtree; f < root; ++f) put(f, level[f]);
    put(root, kept);
  }
  top[0] = top[1] = 0;
  for (const int f : tops_) put(f, level[f]);
  for (auto& stacks : stacks_)
    for (std::size_t s = 0; s < 2; ++s) stacks[s].resize(most[s]);
  kept_.resize(most[kept]);
}

template <class Real>
Real* SparseSolver<Real>::find_changes(int f, int thread) {
  const Place& place = places_[f];
  return (place.stack == kept ? kept_ : stacks_[thread][place.stack]).data() + place.changes;
}

/// Sets a front to the values of the matrix that enter it.
template <class Real>
void SparseSolver<Real>::add_values(const std::vector<double>& values, int f) {
  const Place &from = places_[f], &to = places_[f + 1];
  Real *lower = lower_.data() + from.lower, *upper = upper_.data() + from.upper;
  std::fill(lower, lower_.data() + to.lower, Real(0));
  if (factors_ == Factors::lu) std::fill(upper, upper_.data() + to.upper, Real(0));
  for (std::size_t k = from.value; k < to.value; ++k) {
    if (slots_[k] >= 0)
      lower[slots_[k]] = static_cast<Real>(values[order_[k]]);
    else if (factors_ == Factors::lu)
      upper[-1 - slots_[k]] = static_cast<Real>(values[order_[k]]);
  }
}

/// Adds to a front what its children have left to it.
template <class Real>
void SparseSolver<Real>::add_changes_of_children(int f, int thread) {
  const Front& front = plan_.fronts[f];
  const bool symmetric = factors_ == Factors::ldlt;
  const std::ptrdiff_t pivots = front.pivots, size = front.size(), count = size - pivots;
  Real *lower = lower_.data() + places_[f].lower, *upper = upper_.data() + places_[f].upper,
       *changes = find_changes(f, thread);
  for (std::ptrdiff_t j = 0; j < count; ++j)
    std::fill(changes + j * count + (symmetric ? j : 0), changes + (j + 1) * count, Real(0));
  for (const int c : front.children) {
    const Front& child = plan_.fronts[c];
    const std::ptrdiff_t rows = static_cast<std::ptrdiff_t>(child.rows.size());
    const Real* from = find_changes(c, thread);
    for (const Run& across : child.runs)
      for (int j = 0; j < across.count; ++j, from += rows) {
        const std::ptrdiff_t column = across.to + j;
        for (const Run& down : child.runs) {
          const int first = symmetric ? std::max(0, across.from + j - down.from) : 0;
          if (first >= down.count) continue;
          Real* to = column < pivots    ? lower + column * size + down.to
                     : down.to < pivots ? upper + (column - pivots) * pivots + down.to
                                        : changes + (column - pivots) * count + down.to - pivots;
          for (int i = first; i < down.count; ++i) to[i] += from[down.from + i];
        }
      }
  }
}

template <class Real>
bool SparseSolver<Real>::eliminate_ldlt(int f, int threads, int thread) {
  const Front& front = plan_.fronts[f];
  const int pivots = front.pivots, size = front.size(), count = size - pivots;
  Real* at = lower_.data() + places_[f].lower;
  Block<Real> own(at, pivots, pivots, Stride(size)), below(at + pivots, count, pivots, Stride(size)),
      changes(find_changes(f, thread), count, count, Stride(count));
  if (!factorise_ldlt<Real>(own)) return false;
  negative_[f] = static_cast<int>((own.diagonal().array() < 0).count());
  if (count == 0) return true;
  own.template triangularView<Eigen::UnitLower>().transpose().template solveInPlace<Eigen::OnTheRight>(below);
  const Matrix<Real> scaled = below;  // L D
  below = scaled * own.diagonal().cwiseInverse().asDiagonal();
  parallel_tasks((count + chunk - 1) / chunk, threads, [&](int piece) {
    const int first = piece * chunk, width = std::min(chunk, count - first), rest = count - first - width;
    changes.block(first, first, width, width).template triangularView<Eigen::Lower>() -=
        scaled.middleRows(first, width) * below.middleRows(first, width).transpose();
    if (rest > 0)
      changes.block(first + width, first, rest, width).noalias() -=
          scaled.bottomRows(rest) * below.middleRows(first, width).transpose();
  });
  return true;
}

template <class Real>
bool SparseSolver<Real>::eliminate_lu(int f, int threads, int thread) {
  const Front& front = plan_.fronts[f];
  const int pivots = front.pivots, size = front.size(), count = size - pivots;
  Real* at = lower_.data() + places_[f].lower;
  Block<Real> own(at, pivots, pivots, Stride(size)), below(at + pivots, count, pivots, Stride(size)),
      right(upper_.data() + places_[f].upper, pivots, count, Stride(pivots)),
      changes(find_changes(f, thread), count, count, Stride(count));
  Eigen::Ref<Matrix<Real>, 0, Stride> in_place(own);
  const Eigen::PartialPivLU<decltype(in_place)> lu(in_place);
  if (!own.diagonal().allFinite() || (own.diagonal().array() == 0).any()) return false;
  std::copy_n(lu.permutationP().indices().data(), pivots, exchanged_.begin() + front.first);
  if (count == 0) return true;
  const bool is_exchanged =
      !std::is_sorted(exchanged_.begin() + front.first, exchanged_.begin() + front.first + pivots);
  parallel_tasks((count + chunk - 1) / chunk, threads, [&](int piece) {
    const int first = piece * chunk, width = std::min(chunk, count - first);
    auto columns = right.middleCols(first, width);
    if (is_exchanged) columns = (lu.permutationP() * columns).eval();
    own.template triangularView<Eigen::UnitLower>().solveInPlace(columns);
    auto rows = below.middleRows(first, width);
    own.template triangularView<Eigen::Upper>().template solveInPlace<Eigen::OnTheRight>(rows);
  });
  parallel_tasks((count + chunk - 1) / chunk, threads, [&](int piece) {
    const int first = piece * chunk, width = std::min(chunk, count - first);
    changes.middleCols(first, width).noalias() -= below * right.middleCols(first, width);
  });
  return true;
}

template <class Real>
bool SparseSolver<Real>::eliminate(const std::vector<double>& values, int f, int threads, int thread) {
  add_values(values, f);
  add_changes_of_children(f, thread);
  return factors_ == Factors::ldlt ? eliminate_ldlt(f, threads, thread) : eliminate_lu(f, threads, thread);
}

template <class Real>
bool SparseSolver<Real>::factorise(const std::vector<double>& values, Factors factors) {
  factors_ = factors;
  ++factorisations_;
  std::vector<char> good(subtrees_.size(), 1);
  parallel_tasks(static_cast<int>(subtrees_.size()), threads_, [&](int s, int thread) {
    for (int f = plan_.fronts[subtrees_[s]].first_of_subtree; f <= subtrees_[s] && good[s]; ++f)
      good[s] = eliminate(values, f, 1, thread);
  });
  if (std::find(good.begin(), good.end(), 0) != good.end()) return false;
  for (const int f : tops_)
    if (!eliminate(values, f, threads_, 0)) return false;
  negative_pivots_ = factors == Factors::ldlt ? std::accumulate(negative_.begin(), negative_.end(), 0) : 0;
  return true;
}

/// Eliminates the pivots of a front from the right-hand side. What they leave to the rows above waits in `updates_` for
/// the parent, so that sums have one order for any number of threads.
template <class Real>
void SparseSolver<Real>::substitute(int f, Real* y, std::vector<Real>& work) {
  const Front& front = plan_.fronts[f];
  const int pivots = front.pivots, size = front.size(), count = size - pivots;
  const Real* at = lower_.data() + places_[f].lower;
  const ConstBlock<Real> own(at, pivots, pivots, Stride(size)), below(at + pivots, count, pivots, Stride(size));
  Column<Real> b(y + front.first, pivots), rest(updates_.data() + places_[f].update, count);
  rest.setZero();
  for (const int c : front.children) {
    const Real* from = updates_.data() + places_[c].update;
    for (const Run& run : plan_.fronts[c].runs) {
      Real* to = run.to < pivots ? b.data() + run.to : rest.data() + run.to - pivots;
      for (int i = 0; i < run.count; ++i) to[i] += from[run.from + i];
    }
  }
  if (factors_ == Factors::lu) {
    work.assign(b.begin(), b.end());
    for (int i = 0; i < pivots; ++i) b[exchanged_[front.first + i]] = work[i];
  }
  own.template triangularView<Eigen::UnitLower>().solveInPlace(b);
  if (count > 0) rest.noalias() -= below * b;
}

/// Finds the unknowns of a front's pivots from those of its other rows.
template <class Real>
void SparseSolver<Real>::substitute_back(int f, Real* y, std::vector<Real>& work) const {
  const Front& front = plan_.fronts[f];
  const int pivots = front.pivots, size = front.size(), count = size - pivots;
  const Real* at = lower_.data() + places_[f].lower;
  const ConstBlock<Real> own(at, pivots, pivots, Stride(size)), below(at + pivots, count, pivots, Stride(size)),
      right(upper_.data() + places_[f].upper, pivots, count, Stride(pivots));
  Column<Real> b(y + front.first, pivots);
  work.resize(count);
  for (int i = 0; i < count; ++i) work[i] = y[front.rows[i]];
  const Column<Real> rest(work.data(), count);
  if (factors_ == Factors::ldlt) {
    b = b.cwiseQuotient(own.diagonal());
    b.noalias() -= below.transpose() * rest;
    own.template triangularView<Eigen::UnitLower>().transpose().solveInPlace(b);
  } else {
    b.noalias() -= right * rest;
    own.template triangularView<Eigen::Upper>().solveInPlace(b);
  }
}

template <class Real>
bool SparseSolver<Real>::solve(std::vector<double>& x) {
  AlignedVector<Real> y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) y[plan_.position[i]] = static_cast<Real>(x[i]);
  const int subtrees = static_cast<int>(subtrees_.size());
  std::vector<Real> work;
  parallel_tasks(subtrees, threads_, [&](int s) {
    std::vector<Real> own_work;
    for (int f = plan_.fronts[subtrees_[s]].first_of_subtree; f <= subtrees_[s]; ++f) substitute(f, y.data(), own_work);
  });
  for (const int f : tops_) substitute(f, y.data(), work);
  for (auto f = tops_.rbegin(); f != tops_.rend(); ++f) substitute_back(*f, y.data(), work);
  parallel_tasks(subtrees, threads_, [&](int s) {
    std::vector<Real> own_work;
    for (int f = subtrees_[s]; f >= plan_.fronts[subtrees_[s]].first_of_subtree; --f)
      substitute_back(f, y.data(), own_work);
  });
  bool finite = true;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = y[plan_.position[i]];
    finite = finite && std::isfinite(x[i]);
  }
  return finite;
}

template class SparseSolver<double>;
template class SparseSolver<float>;

}  // namespace talus::sparse
