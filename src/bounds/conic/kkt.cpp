// SPDX-License-Identifier: MIT
// Elimination of cones and local variables, factorisation of the quasi-definite remainder, and iterative refinement.
#include "bounds/conic/kkt.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "sparse/gmres.hpp"
#include "sparse/solver.hpp"

namespace talus::bounds {

namespace {

constexpr int most_changes = 8;
/// Limits of the local variables: a variable in more cones, or in a larger group, is not eliminated. A corner with a
/// curved envelope has a cone for every line.
constexpr int most_cones = 24;
constexpr std::size_t largest_group = 6;

double measure_square(const std::vector<double>& u) {
  return std::inner_product(u.begin(), u.end(), u.begin(), 0.0);
}

std::size_t find_neighbour(const std::vector<int>& neighbours, int unknown) {
  return static_cast<std::size_t>(std::lower_bound(neighbours.begin(), neighbours.end(), unknown) - neighbours.begin());
}

}  // namespace

struct Kkt::Library {
  std::vector<int> first{0}, row;  ///< pattern of the lower triangle: first entry of each column, and rows
  std::vector<double> values;
  std::unique_ptr<sparse::SparseSolver<>> solver;
  std::vector<double> fixed;  ///< values of the rows of the equations
};

Kkt::Kkt(const ConicProgram& program, const KktAccuracy& accuracy)
    : program_(program), accuracy_(accuracy), library_(std::make_unique<Library>()) {
  find_blocks();
  find_groups();
  list_neighbours();
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

/// Groups variables that share a cone, if each of them is in few cones.
void Kkt::find_groups() {
  const auto n = static_cast<std::size_t>(program_.variables);
  std::vector<int> cones(n, 0), parent(n);
  std::iota(parent.begin(), parent.end(), 0);
  for (const Block& block : blocks_)
    for (const int c : block.columns) ++cones[static_cast<std::size_t>(c)];
  const auto is_local = [&](int c) {
    const int count = cones[static_cast<std::size_t>(c)];
    return count > 0 && count <= most_cones;
  };
  const auto find_root = [&](int c) {
    while (parent[static_cast<std::size_t>(c)] != c) c = parent[static_cast<std::size_t>(c)];
    return c;
  };
  for (const Block& block : blocks_) {
    int first = -1;
    for (const int c : block.columns) {
      if (!is_local(c)) continue;
      const int root = find_root(c);
      if (first < 0) first = root;
      parent[static_cast<std::size_t>(std::max(root, first))] = std::min(root, first);
      first = std::min(root, first);
    }
  }
  std::map<int, std::vector<int>> members;
  for (int c = 0; c < program_.variables; ++c)
    if (is_local(c)) members[find_root(c)].push_back(c);
  group_of_.assign(n, -1), rank_of_.assign(n, 0);
  for (auto& [root, own] : members) {
    if (own.size() > largest_group) continue;
    for (std::size_t i = 0; i < own.size(); ++i) {
      group_of_[static_cast<std::size_t>(own[i])] = static_cast<int>(groups_.size());
      rank_of_[static_cast<std::size_t>(own[i])] = static_cast<int>(i);
    }
    groups_.push_back({std::move(own), {}, 0, 0, {}});
  }
  for (std::size_t c = 0; c < n; ++c)
    if (group_of_[c] < 0) rank_of_[c] = globals_++;
}

/// Lists the unknowns that each group is coupled with: the other variables of its cones, and the equations in which it
/// occurs. The coefficients of equations do not change between factorisations.
void Kkt::list_neighbours() {
  for (const Block& block : blocks_)
    for (const int own : block.columns) {
      const int group = group_of_[static_cast<std::size_t>(own)];
      if (group < 0) continue;
      for (const int other : block.columns)
        if (group_of_[static_cast<std::size_t>(other)] < 0)
          groups_[static_cast<std::size_t>(group)].neighbours.push_back(rank_of_[static_cast<std::size_t>(other)]);
    }
  const SparseRows& a = program_.rows;
  for (int r = 0; r < program_.equations; ++r)
    for (std::size_t k = a.begin(r); k < a.begin(r + 1); ++k)
      if (const int group = group_of_[static_cast<std::size_t>(a.column[k])]; group >= 0)
        groups_[static_cast<std::size_t>(group)].neighbours.push_back(globals_ + r);
  std::size_t size = 0;
  for (Group& group : groups_) {
    std::sort(group.neighbours.begin(), group.neighbours.end());
    group.neighbours.erase(std::unique(group.neighbours.begin(), group.neighbours.end()), group.neighbours.end());
    const std::size_t k = group.variables.size();
    group.own = size, group.coupling = size + k * k;
    size += k * k + k * group.neighbours.size();
  }
  fixed_dense_.assign(size, 0);
  for (const Group& group : groups_)
    for (std::size_t i = 0, k = group.variables.size(); i < k; ++i)
      fixed_dense_[group.own + i * k + i] = accuracy_.shift;
  for (int r = 0; r < program_.equations; ++r)
    for (std::size_t k = a.begin(r); k < a.begin(r + 1); ++k) {
      const auto column = static_cast<std::size_t>(a.column[k]);
      if (group_of_[column] < 0) continue;
      const Group& group = groups_[static_cast<std::size_t>(group_of_[column])];
      fixed_dense_[group.coupling + static_cast<std::size_t>(rank_of_[column]) * group.neighbours.size() +
                   find_neighbour(group.neighbours, globals_ + r)] += a.value[k];
    }
}

/// Returns the index of an entry of the lower triangle in the values of the matrix.
int Kkt::find_place(std::size_t column, std::size_t row) const {
  const Library& m = *library_;
  if (row < column) std::swap(row, column);
  const auto begin = m.row.begin();
  return static_cast<int>(
      std::lower_bound(begin + m.first[column], begin + m.first[column + 1], static_cast<int>(row)) - begin);
}

void Kkt::place_products(Block& block) const {
  for (std::size_t i = 0; i < block.columns.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const auto a = static_cast<std::size_t>(block.columns[i]), b = static_cast<std::size_t>(block.columns[j]);
      const int of_a = group_of_[a], of_b = group_of_[b], rank_a = rank_of_[a], rank_b = rank_of_[b];
      if (of_a < 0 && of_b < 0) {
        block.places.push_back(find_place(static_cast<std::size_t>(rank_a), static_cast<std::size_t>(rank_b)));
        continue;
      }
      const Group& group = groups_[static_cast<std::size_t>(of_a < 0 ? of_b : of_a)];
      const std::size_t k = group.variables.size();
      std::size_t at = 0;
      if (of_a >= 0 && of_b >= 0) {
        const auto high = static_cast<std::size_t>(std::max(rank_a, rank_b)),
                   low = static_cast<std::size_t>(std::min(rank_a, rank_b));
        at = group.own + high * k + low;
      } else {
        at = group.coupling + static_cast<std::size_t>(of_a < 0 ? rank_b : rank_a) * group.neighbours.size() +
             find_neighbour(group.neighbours, of_a < 0 ? rank_a : rank_b);
      }
      block.places.push_back(-1 - static_cast<int>(at));
    }
}

void Kkt::find_pattern() {
  const int size = globals_ + program_.equations;
  std::vector<std::vector<int>> below(static_cast<std::size_t>(size));
  const auto add = [&](int one, int other) {
    below[static_cast<std::size_t>(std::min(one, other))].push_back(std::max(one, other));
  };
  for (int i = 0; i < size; ++i) add(i, i);
  const SparseRows& a = program_.rows;
  const auto visit_equations = [&](auto use) {
    for (int r = 0; r < program_.equations; ++r)
      for (std::size_t k = a.begin(r); k < a.begin(r + 1); ++k) {
        const auto column = static_cast<std::size_t>(a.column[k]);
        if (group_of_[column] < 0) use(globals_ + r, rank_of_[column], a.value[k]);
      }
  };
  visit_equations([&](int row, int column, double) { add(row, column); });
  for (const Block& block : blocks_)
    for (std::size_t i = 0; i < block.columns.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const auto one = static_cast<std::size_t>(block.columns[i]), other = static_cast<std::size_t>(block.columns[j]);
        if (group_of_[one] < 0 && group_of_[other] < 0) add(rank_of_[one], rank_of_[other]);
      }
  for (const Group& group : groups_)
    for (std::size_t i = 0; i < group.neighbours.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) add(group.neighbours[i], group.neighbours[j]);
  Library& m = *library_;
  for (std::vector<int>& rows : below) {
    std::sort(rows.begin(), rows.end());
    m.row.insert(m.row.end(), rows.begin(), std::unique(rows.begin(), rows.end()));
    m.first.push_back(static_cast<int>(m.row.size()));
  }
  std::vector<double>& fixed = library_->fixed;
  fixed.assign(m.row.size(), 0);
  for (int i = 0; i < size; ++i)
    fixed[static_cast<std::size_t>(m.first[static_cast<std::size_t>(i)])] =
        i < globals_ ? accuracy_.shift : -accuracy_.shift;
  visit_equations([&](int row, int column, double value) {
    fixed[static_cast<std::size_t>(find_place(static_cast<std::size_t>(column), static_cast<std::size_t>(row)))] +=
        value;
  });
  for (Block& block : blocks_) place_products(block);
  for (Group& group : groups_)
    for (std::size_t i = 0; i < group.neighbours.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        group.places.push_back(
            find_place(static_cast<std::size_t>(group.neighbours[j]), static_cast<std::size_t>(group.neighbours[i])));
  m.solver = std::make_unique<sparse::SparseSolver<>>(m.first, m.row, 1, sparse::Stored::lower);
}

// Adds Aᵀ H⁻¹ A of a block as the product of W⁻¹ A with itself, which is symmetric and positive semidefinite in spite
// of rounding.
void Kkt::add_products(const Block& block, const Scaling& scaling, std::vector<double>& scaled) {
  const std::size_t n = block.columns.size(), rows = static_cast<std::size_t>(block.rows);
  double* values = library_->values.data();
  scaled.resize((n + 1) * rows);
  const MutablePart column(scaled.data() + n * rows, rows);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t r = 0; r < rows; ++r) column[r] = block.values[r * n + j];
    scaling.apply(column, true, MutablePart(scaled.data() + j * rows, rows));
  }
  std::size_t k = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const int place = block.places[k++];
      (place >= 0 ? values[place] : dense_[static_cast<std::size_t>(-1 - place)]) +=
          multiply(Part(scaled.data() + i * rows, rows), Part(scaled.data() + j * rows, rows));
    }
}

// Factorises the matrix of a group as L Lᵀ and subtracts (L⁻¹ U)ᵀ (L⁻¹ U) from that of its neighbours.
bool Kkt::eliminate(const Group& group) {
  const std::size_t k = group.variables.size(), q = group.neighbours.size();
  double *own = &dense_[group.own], *coupling = dense_.data() + group.coupling;
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = own[i * k + j];
      for (std::size_t l = 0; l < j; ++l) sum -= own[i * k + l] * own[j * k + l];
      if (i == j && !(sum > 0)) return false;
      own[i * k + j] = i == j ? std::sqrt(sum) : sum / own[j * k + j];
    }
    for (std::size_t l = 0; l < i; ++l)
      for (std::size_t c = 0; c < q; ++c) coupling[i * q + c] -= own[i * k + l] * coupling[l * q + c];
    for (std::size_t c = 0; c < q; ++c) coupling[i * q + c] /= own[i * k + i];
  }
  double* values = library_->values.data();
  std::size_t at = 0;
  for (std::size_t i = 0; i < q; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0;
      for (std::size_t l = 0; l < k; ++l) sum += coupling[l * q + i] * coupling[l * q + j];
      values[group.places[at++]] -= sum;
    }
  return true;
}

bool Kkt::factorise(const std::vector<Scaling>& scalings) {
  scalings_ = &scalings;
  library_->values = library_->fixed;
  dense_ = fixed_dense_;
  std::vector<double> scaled;
  for (std::size_t c = 0; c < blocks_.size(); ++c) add_products(blocks_[c], scalings[c], scaled);
  for (const Group& group : groups_)
    if (!eliminate(group)) return false;
  return library_->solver->factorise(library_->values, sparse::Factors::ldlt);
}

void Kkt::apply_inverse(const Block& block, const Scaling& scaling, const double* u, double* out) const {
  const auto rows = static_cast<std::size_t>(block.rows);
  const MutablePart part(out, rows);
  scaling.apply_square(Part(u, rows), true, part);
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
    (*scalings_)[c].apply_square(Part(z).subspan(first, rows), false, turned);
    for (std::size_t r = 0; r < rows; ++r) g[first + r] += turned[r];
  }
}

bool Kkt::solve_reduced(const std::vector<double>& f, const std::vector<double>& g, std::vector<double>& x,
                        std::vector<double>& z) const {
  x = f;
  std::vector<double> lifted(3);
  for (std::size_t c = 0; c < blocks_.size(); ++c) {
    const Block& block = blocks_[c];
    const std::size_t n = block.columns.size();
    lifted.resize(static_cast<std::size_t>(block.rows));
    apply_inverse(block, (*scalings_)[c], g.data() + block.first_row, lifted.data());
    for (std::size_t r = 0; r < lifted.size(); ++r)
      for (std::size_t j = 0; j < n; ++j)
        x[static_cast<std::size_t>(block.columns[j])] += block.values[r * n + j] * lifted[r];
  }
  const auto equations = static_cast<std::size_t>(program_.equations);
  std::vector<double> right(static_cast<std::size_t>(globals_) + equations);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (group_of_[i] < 0) right[static_cast<std::size_t>(rank_of_[i])] = x[i];
  std::copy_n(g.begin(), equations, right.data() + globals_);
  for (const Group& group : groups_) reduce_right(group, x, right.data());
  if (!library_->solver->solve(right)) return false;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (group_of_[i] < 0) x[i] = right[static_cast<std::size_t>(rank_of_[i])];
  for (const Group& group : groups_) recover(group, right.data(), x);
  z.resize(g.size());
  std::copy_n(right.data() + globals_, equations, z.begin());
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

// Forward substitution: x of the group becomes L⁻¹ x, and its contribution is subtracted from the rest.
void Kkt::reduce_right(const Group& group, std::vector<double>& x, double* right) const {
  const std::size_t k = group.variables.size(), q = group.neighbours.size();
  const double *own = &dense_[group.own], *coupling = dense_.data() + group.coupling;
  for (std::size_t i = 0; i < k; ++i) {
    double& at = x[static_cast<std::size_t>(group.variables[i])];
    for (std::size_t l = 0; l < i; ++l) at -= own[i * k + l] * x[static_cast<std::size_t>(group.variables[l])];
    at /= own[i * k + i];
    for (std::size_t c = 0; c < q; ++c) right[group.neighbours[c]] -= coupling[i * q + c] * at;
  }
}

// Back substitution: L⁻ᵀ (L⁻¹ x − L⁻¹ U y).
void Kkt::recover(const Group& group, const double* rest, std::vector<double>& x) const {
  const std::size_t k = group.variables.size(), q = group.neighbours.size();
  const double *own = &dense_[group.own], *coupling = dense_.data() + group.coupling;
  for (std::size_t i = k; i-- > 0;) {
    double& at = x[static_cast<std::size_t>(group.variables[i])];
    for (std::size_t c = 0; c < q; ++c) at -= coupling[i * q + c] * rest[group.neighbours[c]];
    for (std::size_t l = i + 1; l < k; ++l) at -= own[l * k + i] * x[static_cast<std::size_t>(group.variables[l])];
    at /= own[i * k + i];
  }
}

// One solution by the factors usually suffices. Where its residual is too large, GMRES preconditioned by the factors
// corrects it: the shift of the diagonal perturbs few directions but those strongly, and repeated refinement would
// converge slowly. The residual is computed with the original rows, with H: in the eliminated form, with H⁻¹, it would
// be lost in the rounding of the largest terms.
bool Kkt::solve(const std::vector<double>& f, const std::vector<double>& g, std::vector<double>& x,
                std::vector<double>& z) const {
  const double asked = accuracy_.left_over * std::sqrt(measure_square(f) + measure_square(g));
  std::vector<double> left_f = f, left_g = g;
  if (!solve_reduced(f, g, x, z)) return false;
  find_residual(x, z, left_f, left_g);
  const double left = std::sqrt(measure_square(left_f) + measure_square(left_g));
  return left <= asked || correct(asked, left_f, left_g, x, z);
}

bool Kkt::correct(double asked, const std::vector<double>& left_f, const std::vector<double>& left_g,
                  std::vector<double>& x, std::vector<double>& z) const {
  const std::size_t n = x.size();
  std::vector<double> f, g, dx, dz, change;
  const auto split = [&](const std::vector<double>& both) {
    f.assign(both.begin(), both.begin() + static_cast<std::ptrdiff_t>(n));
    g.assign(both.begin() + static_cast<std::ptrdiff_t>(n), both.end());
  };
  const auto join = [](const std::vector<double>& upper, const std::vector<double>& lower) {
    std::vector<double> both = upper;
    both.insert(both.end(), lower.begin(), lower.end());
    return both;
  };
  const sparse::LinearMap invert = [&](std::vector<double>& both) {
    split(both);
    if (!solve_reduced(f, g, dx, dz)) return false;
    both = join(dx, dz);
    return true;
  };
  const sparse::LinearMap apply = [&](std::vector<double>& both) {
    split(both);
    dx.assign(f.size(), 0), dz.assign(g.size(), 0);
    find_residual(f, g, dx, dz);
    both = join(dx, dz);
    for (double& v : both) v = -v;
    return true;
  };
  const std::vector<double> left = join(left_f, left_g);
  const double norm = std::sqrt(measure_square(left));
  if (!std::isfinite(norm)) return false;
  if (!std::isfinite(sparse::solve_by_gmres(apply, invert, left, asked / norm, most_changes, change))) return false;
  for (std::size_t i = 0; i < n; ++i) x[i] += change[i];
  for (std::size_t i = 0; i < z.size(); ++i) z[i] += change[n + i];
  return true;
}

}  // namespace talus::bounds
