// SPDX-License-Identifier: MIT
// Elimination of the cones, factors of the quasi-definite rest, and refinement.

#include "bounds/conic/kkt.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::bounds {

namespace {

/// Added to the diagonal, with the sign of each block, of a program whose entries are about one. Factors of a
/// quasi-definite matrix need no pivots (Vanderbei 1995); the refinement takes its effect away. A variable in no cone
/// and an equation have only this: their product must stay above the rounding of one.
constexpr double shift = 1e-7;
constexpr int most_changes = 8;

}  // namespace

struct Kkt::Library {
  Eigen::SparseMatrix<double> matrix;  ///< lower triangle
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors;
  std::vector<double> fixed;  ///< values of the equations' rows
};

Kkt::Kkt(const ConicProgram& program) : program_(program), library_(std::make_unique<Library>()) {
  find_blocks();
  find_pattern();
}

Kkt::~Kkt() = default;

void Kkt::find_blocks() {
  const SparseRows& a = program_.rows;
  int row = program_.equations;
  for (const int size : program_.cones) {
    Block block;
    block.first_row = row, block.rows = size;
    block.columns.assign(a.column.data() + a.begin(row), a.column.data() + a.begin(row + size));
    std::sort(block.columns.begin(), block.columns.end());
    block.columns.erase(std::unique(block.columns.begin(), block.columns.end()), block.columns.end());
    const std::size_t n = block.columns.size();
    block.values.assign(static_cast<std::size_t>(size) * n, 0);
    for (int r = 0; r < size; ++r)
      for (std::size_t k = a.begin(row + r); k < a.begin(row + r + 1); ++k) {
        const auto at =
            std::lower_bound(block.columns.begin(), block.columns.end(), a.column[k]) - block.columns.begin();
        block.values[static_cast<std::size_t>(r) * n + static_cast<std::size_t>(at)] = a.value[k];
      }
    blocks_.push_back(std::move(block));
    row += size;
  }
}

void Kkt::find_pattern() {
  const int n = program_.variables, size = n + program_.equations;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, i < n ? shift : -shift);
  const SparseRows& a = program_.rows;
  for (int r = 0; r < program_.equations; ++r)
    for (std::size_t k = a.begin(r); k < a.begin(r + 1); ++k) entries.emplace_back(n + r, a.column[k], a.value[k]);
  for (const Block& block : blocks_)
    for (std::size_t i = 0; i < block.columns.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) entries.emplace_back(block.columns[i], block.columns[j], 0.0);
  auto& m = library_->matrix;
  m.resize(size, size);
  m.setFromTriplets(entries.begin(), entries.end());
  library_->fixed.assign(m.valuePtr(), m.valuePtr() + m.nonZeros());
  for (Block& block : blocks_)
    for (std::size_t i = 0; i < block.columns.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const int* begin = m.innerIndexPtr() + m.outerIndexPtr()[block.columns[j]];
        const int* end = m.innerIndexPtr() + m.outerIndexPtr()[block.columns[j] + 1];
        block.places.push_back(static_cast<int>(std::lower_bound(begin, end, block.columns[i]) - m.innerIndexPtr()));
      }
  library_->factors.analyzePattern(m);
}

bool Kkt::factorise(const std::vector<Scaling>& scalings) {
  scalings_ = &scalings;
  double* values = library_->matrix.valuePtr();
  std::copy(library_->fixed.begin(), library_->fixed.end(), values);
  std::vector<double> scaled, column(3);
  for (std::size_t c = 0; c < blocks_.size(); ++c) {
    const Block& block = blocks_[c];
    const std::size_t n = block.columns.size(), rows = static_cast<std::size_t>(block.rows);
    // W⁻¹ times the block: its own product with itself is Aᵀ H⁻¹ A, symmetric and positive whatever is rounded.
    scaled.resize(n * rows), column.resize(rows);
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t r = 0; r < rows; ++r) column[r] = block.values[r * n + j];
      scalings[c].apply(column, true, MutablePart(scaled.data() + j * rows, rows));
    }
    std::size_t k = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        values[block.places[k++]] +=
            multiply(Part(scaled.data() + i * rows, rows), Part(scaled.data() + j * rows, rows));
  }
  library_->factors.factorize(library_->matrix);
  return library_->factors.info() == Eigen::Success && library_->factors.vectorD().allFinite();
}

void Kkt::apply_inverse(const Block& block, const Scaling& scaling, const double* u, double* out) const {
  const auto rows = static_cast<std::size_t>(block.rows);
  const MutablePart part(out, rows);
  scaling.apply(Part(u, rows), true, part);
  scaling.apply(part, true, part);
}

void Kkt::find_residual(const std::vector<double>& x, const std::vector<double>& z, std::vector<double>& f,
                        std::vector<double>& g) const {
  const SparseRows& a = program_.rows;
  for (int r = 0; r < a.count(); ++r) {
    const auto row = static_cast<std::size_t>(r);
    for (auto k = static_cast<std::size_t>(a.first[row]); k < static_cast<std::size_t>(a.first[row + 1]); ++k) {
      const auto j = static_cast<std::size_t>(a.column[k]);
      f[j] -= a.value[k] * z[row];
      g[row] -= a.value[k] * x[j];
    }
  }
  std::vector<double> turned;
  for (std::size_t c = 0; c < blocks_.size(); ++c) {
    const auto first = static_cast<std::size_t>(blocks_[c].first_row), rows = static_cast<std::size_t>(blocks_[c].rows);
    turned.resize(rows);
    (*scalings_)[c].apply(Part(z).subspan(first, rows), false, turned);
    (*scalings_)[c].apply(turned, false, turned);
    for (std::size_t r = 0; r < rows; ++r) g[first + r] += turned[r];
  }
}

bool Kkt::solve_reduced(const std::vector<double>& f, const std::vector<double>& g, std::vector<double>& x,
                        std::vector<double>& z) const {
  const auto n = static_cast<std::size_t>(program_.variables), equations = static_cast<std::size_t>(program_.equations);
  Eigen::VectorXd right(static_cast<Eigen::Index>(n + equations));
  std::copy(f.begin(), f.end(), right.data());
  std::copy_n(g.begin(), equations, right.data() + n);
  std::vector<double> lifted(3);
  for (std::size_t c = 0; c < blocks_.size(); ++c) {
    const Block& block = blocks_[c];
    lifted.resize(static_cast<std::size_t>(block.rows));
    apply_inverse(block, (*scalings_)[c], g.data() + block.first_row, lifted.data());
    for (std::size_t r = 0; r < lifted.size(); ++r)
      for (std::size_t j = 0; j < block.columns.size(); ++j)
        right[block.columns[j]] += block.values[r * block.columns.size() + j] * lifted[r];
  }
  const Eigen::VectorXd found = library_->factors.solve(right);
  if (!found.allFinite()) return false;
  x.assign(found.data(), found.data() + n);
  z.resize(g.size());
  std::copy_n(found.data() + n, equations, z.begin());
  for (std::size_t c = 0; c < blocks_.size(); ++c) {
    const Block& block = blocks_[c];
    lifted.assign(static_cast<std::size_t>(block.rows), 0);
    for (std::size_t r = 0; r < lifted.size(); ++r) {
      for (std::size_t j = 0; j < block.columns.size(); ++j)
        lifted[r] += block.values[r * block.columns.size() + j] * x[static_cast<std::size_t>(block.columns[j])];
      lifted[r] -= g[static_cast<std::size_t>(block.first_row) + r];
    }
    apply_inverse(block, (*scalings_)[c], lifted.data(), z.data() + block.first_row);
  }
  return true;
}

// GMRES with the factors as its preconditioner: the small diagonal changes few directions, but those by much, and such
// an iteration finds them where repeated refinement would creep. What is left is measured in the rows as they stand,
// with H: in those of the elimination, with H⁻¹, it would drown in the rounding of the largest.
bool Kkt::solve(const std::vector<double>& f, const std::vector<double>& g, std::vector<double>& x,
                std::vector<double>& z) const {
  const Eigen::Index n = static_cast<Eigen::Index>(f.size()), size = n + static_cast<Eigen::Index>(g.size());
  x.assign(f.size(), 0), z.assign(g.size(), 0);
  std::vector<double> left_f = f, left_g = g;
  Eigen::MatrixXd basis(size, most_changes + 1), changes(size, most_changes),
      h = Eigen::MatrixXd::Zero(most_changes + 1, most_changes);
  const auto gather = [&](auto column) {
    column << Eigen::Map<const Eigen::VectorXd>(left_f.data(), n),
        Eigen::Map<const Eigen::VectorXd>(left_g.data(), size - n);
  };
  gather(basis.col(0));
  const double norm = basis.col(0).norm();
  if (norm == 0) return true;
  basis.col(0) /= norm;
  Eigen::VectorXd first = Eigen::VectorXd::Zero(most_changes + 1), factors;
  first[0] = norm;
  std::vector<double> dx, dz;
  for (int k = 0; k < most_changes; ++k) {
    std::copy_n(basis.col(k).data(), n, left_f.begin());
    std::copy_n(basis.col(k).data() + n, size - n, left_g.begin());
    if (!solve_reduced(left_f, left_g, dx, dz)) return false;
    changes.col(k) << Eigen::Map<const Eigen::VectorXd>(dx.data(), n),
        Eigen::Map<const Eigen::VectorXd>(dz.data(), size - n);
    std::fill(left_f.begin(), left_f.end(), 0.0), std::fill(left_g.begin(), left_g.end(), 0.0);
    find_residual(dx, dz, left_f, left_g);
    gather(basis.col(k + 1));
    basis.col(k + 1) *= -1;
    for (int pass = 0; pass < 2; ++pass)
      for (int j = 0; j <= k; ++j) {
        const double along = basis.col(j).dot(basis.col(k + 1));
        h(j, k) += along;
        basis.col(k + 1) -= along * basis.col(j);
      }
    h(k + 1, k) = basis.col(k + 1).norm();
    const auto used = h.topLeftCorner(k + 2, k + 1);
    factors = used.householderQr().solve(first.head(k + 2));
    const double left = (first.head(k + 2) - used * factors).norm();
    if (!(h(k + 1, k) > 0) || left <= 1e-10 * norm) break;
    basis.col(k + 1) /= h(k + 1, k);
  }
  const Eigen::VectorXd sum = changes.leftCols(factors.size()) * factors;
  std::copy_n(sum.data(), n, x.begin());
  std::copy_n(sum.data() + n, size - n, z.begin());
  return sum.allFinite();
}

}  // namespace talus::bounds
