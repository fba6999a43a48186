// SPDX-License-Identifier: MIT
// Equilibrium by creep with elastic viscosity. Plain Newton iterations do not find the equilibrium of soil with a
// non-associated flow rule: near collapse the tangent is not positive definite, and the stress return over one long
// increment has no history. A step of equilibrium is therefore integrated as K_el q̇ = residual (T19.5). Its implicit
// Euler steps have a positive definite matrix when they are short and are those of Newton's method when they are long
// (T19.6).
#include "fem/solid/newton.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/progress.hpp"
#include "sparse/gmres.hpp"

namespace talus::fem {
namespace {

constexpr double forcing = 0.1;    ///< residual of a linear system in 3D, over its right-hand side
constexpr double exact = 1e-10;    ///< the same where no soil yields
constexpr int most_products = 12;  ///< GMRES iterations before new factors

using creep::find_norm;

/// Adds the product of a matrix and x to y; without bars, as in 3D.
template <int D>
void add_product(const SolidSystem<D>& system, const std::vector<double>& matrix, const std::vector<double>& x,
                 std::vector<double>& y) {
  const auto add_columns = [&]<int Count>(std::integral_constant<int, Count>, int first) {
    const int start = system.column_start[first], rows = system.column_start[first + 1] - start;
    for (int k = 0; k < rows; ++k) {
      double& sum = y[system.row[start + k]];
      for (int c = 0; c < Count; ++c) sum += x[first + c] * matrix[start + c * rows + k];
    }
  };
  // The columns of a node's unknowns have the same rows: taken together, they load and store y once.
  for (const auto& node : system.nodes) {
    const int free =
        static_cast<int>(std::count_if(node.unknown.begin(), node.unknown.end(), [](int u) { return u >= 0; }));
    if (free == 0) continue;
    const int last = *std::max_element(node.unknown.begin(), node.unknown.end());
    if (free == 1) add_columns(std::integral_constant<int, 1>(), last);
    if (free == 2) add_columns(std::integral_constant<int, 2>(), last - 1);
    if (free == 3) add_columns(std::integral_constant<int, 3>(), last - 2);
  }
}

}  // namespace

template <int D>
SolidNewton<D>::SolidNewton(const SolidSystem<D>& system, const SolidOptions& options)
    : system_(system), options_(options), load_size_(find_norm(system.load)) {
  if (D == 3) rough_ = std::make_unique<sparse::SparseSolver<float>>(system.column_start, system.row, options.threads);
}

template <int D>
void SolidNewton<D>::look(const SolidAssembly<D>& assembly, const SolidState<D>& from, const std::vector<double>& q,
                          const std::vector<double>& target, Place& to) {
  assembly.evaluate(from, q, true, to.state, to.sums);
  to.residual.resize(target.size());
  for (std::size_t i = 0; i < target.size(); ++i) to.residual[i] = target[i] - to.sums.force[i];
  to.fault = find_norm(to.residual);
}

/// Calls work(j) for each column of the matrices.
template <int D>
void SolidNewton<D>::for_columns(auto&& work) const {
  constexpr int piece = 256;
  const int columns = system_.unknowns, threads = options_.threads > 0 ? options_.threads : default_threads();
  parallel_for((columns + piece - 1) / piece, threads, [&](int p) {
    for (int j = p * piece; j < std::min(columns, (p + 1) * piece); ++j) work(j);
  });
}

template <int D>
bool SolidNewton<D>::factorise(bool symmetric) {
  const auto factorise_by = [&](auto& solver) {
    const int before = solver.factorisations();
    has_factors_ = (symmetric && solver.factorise(matrix_, sparse::Factors::ldlt) && solver.negative_pivots() == 0) ||
                   solver.factorise(matrix_, sparse::Factors::lu);
    factorisations_ += solver.factorisations() - before;
    return has_factors_;
  };
  if (rough_) return factorise_by(*rough_);
  if (!solver_) solver_ = std::make_unique<sparse::SparseSolver<>>(system_.column_start, system_.row, options_.threads);
  return factorise_by(*solver_);
}

template <int D>
bool SolidNewton<D>::solve_with_factors(std::vector<double>& x) {
  return rough_ ? rough_->solve(x) : solver_->solve(x);
}

/// Solves the system of matrix_ by GMRES with the last factors. Returns true if the residual is at most `tolerance`
/// times the right-hand side.
template <int D>
bool SolidNewton<D>::solve_approximately(const std::vector<double>& b, double tolerance, std::vector<double>& x) {
  const auto apply = [&](std::vector<double>& y) {
    std::vector<double> product(y.size(), 0);
    add_product(system_, matrix_, y, product);
    y.swap(product);
    return true;
  };
  const auto invert = [&](std::vector<double>& y) { return solve_with_factors(y); };
  return sparse::solve_by_gmres(apply, invert, b, tolerance, most_products, x) <= tolerance;
}

/// Solves the linear system of a Newton iteration for lack_. In 3D factors are expensive and large: they are in single
/// precision, those of an earlier system serve until GMRES needs too many iterations with them, and the solution is
/// inexact, as in the inexact Newton method of Dembo, Eisenstat and Steihaug (1982).
template <int D>
bool SolidNewton<D>::find_change(const SolidSums& sums, double viscosity, std::vector<double>& change) {
  matrix_.resize(sums.matrix.size());
  for_columns([&](int j) {
    for (int k = system_.column_start[j]; k < system_.column_start[j + 1]; ++k)
      matrix_[k] = sums.matrix[k] + viscosity * elastic_[k];
  });
  if (D == 3) return solve_in_3d(sums.symmetric, sums.yielding > 0 ? forcing : exact, lack_, change);
  change = lack_;
  return factorise(sums.symmetric) && solve_with_factors(change);
}

/// Solves the system of matrix_ to a tolerance with the factors at hand, with new ones, or with new ones in double
/// precision, which hardly compressible soil needs.
template <int D>
bool SolidNewton<D>::solve_in_3d(bool symmetric, double tolerance, const std::vector<double>& b,
                                 std::vector<double>& x) {
  if (has_factors_ && solve_approximately(b, tolerance, x)) return true;
  if (factorise(symmetric) && solve_approximately(b, tolerance, x)) return true;
  if (!rough_) return false;
  rough_.reset();
  return factorise(symmetric) && solve_approximately(b, tolerance, x);
}

/// Computes the residual less the viscous forces of a step, into lack_. Returns its norm [N].
template <int D>
double SolidNewton<D>::find_lack(const Place& at, const std::vector<double>& q, double viscosity) {
  lack_.resize(q.size());
  for_columns([&](int j) {  // the elastic matrix is symmetric
    double sum = 0;
    for (int k = system_.column_start[j]; k < system_.column_start[j + 1]; ++k) sum += elastic_[k] * q[system_.row[k]];
    lack_[j] = at.residual[j] - viscosity * sum;
  });
  return find_norm(lack_);
}

/// Solves one implicit creep step from `now`, f_int(q) + β K_el q = target, to a fraction of the out-of-balance force.
/// Returns true if it converged, and the number of linear systems.
template <int D>
std::pair<bool, int> SolidNewton<D>::creep(const SolidAssembly<D>& assembly, const std::vector<double>& target,
                                           const Place& now, double viscosity, Place& next, std::vector<double>& q) {
  q.assign(target.size(), 0);
  lack_ = now.residual;
  double lack = now.fault;
  std::vector<double> more;
  const SolidSums* tangent = &now.sums;
  int solves = 0;
  while (solves < creep::most_solves) {
    throw_if_interrupted();
    if (!find_change(*tangent, viscosity, more)) return {false, solves};
    ++solves;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += more[i];
    look(assembly, now.state, q, target, next);
    tangent = &next.sums;
    const double last = lack;
    lack = find_lack(next, q, viscosity);
    if (lack <= creep::good_share * now.fault) return {true, solves};
    if (creep::is_hopeless(lack, last, now.fault, solves)) break;
  }
  return {viscosity >= creep::most_viscosity && lack < now.fault, solves};
}

/// Returns true if the soil flows: the displacement has doubled while the residual has kept its size (T19.8).
template <int D>
bool SolidNewton<D>::is_steady(double moved, double fault) {
  const bool flows = way_.is_steady(moved, fault, elastic_displacement_, options_.force_tolerance * scale_);
  return elastic_displacement_ > 0 && (flows || moved > options_.runaway * elastic_displacement_);
}

template <int D>
void SolidNewton<D>::find_elastic_displacement() {
  std::vector<double> q = system_.load;
  elastic_displacement_ = 0;
  matrix_ = elastic_;
  if (load_size_ == 0) return;
  if (!(D == 3 ? solve_in_3d(true, exact, system_.load, q) : factorise(true) && solve_with_factors(q))) return;
  for (double x : q) elastic_displacement_ = std::max(elastic_displacement_, std::abs(x));
}

template <int D>
NewtonOutcome SolidNewton<D>::solve(const SolidAssembly<D>& assembly, const SolidState<D>& start,
                                    const std::vector<double>& target, SolidState<D>& end) {
  NewtonOutcome out;
  assembly.find_elastic_matrix(start, elastic_);
  if (elastic_displacement_ < 0) find_elastic_displacement();
  Place now, next;
  std::vector<double> q(target.size(), 0), moved(target.size(), 0);
  look(assembly, start, q, target, now);
  scale_ = load_size_ > 0 ? load_size_ : now.fault;
  const double rounding = 1e-13 * std::max(scale_, find_norm(now.sums.force));
  double viscosity = now.sums.yielding == 0 ? 0 : creep::first_viscosity;
  bool went = false;
  way_.clear();
  last_motion_ = {};
  out.displacement_residual = 1;
  for (;;) {
    out.force_residual = scale_ > 0 ? now.fault / scale_ : 0;
    if (now.fault <= rounding) out.displacement_residual = 0;
    out.converged =
        out.force_residual <= options_.force_tolerance && out.displacement_residual <= options_.displacement_tolerance;
    if (out.converged || out.flows || out.iterations >= options_.most_iterations) break;
    const auto [arrived, solves] = creep(assembly, target, now, viscosity, next, q);
    out.iterations += solves;
    if (!arrived) {
      if (viscosity >= creep::most_viscosity) break;
      viscosity = creep::stiffen(viscosity, went);
      continue;
    }
    went = true;
    for (std::size_t i = 0; i < q.size(); ++i) moved[i] += q[i];
    double largest = 0;
    for (double x : moved) largest = std::max(largest, std::abs(x));
    // The remaining motion if the residual continues to decay at the same ratio (T19.7). The last correction alone may
    // be small only because the creep is slow.
    const double fading = now.fault > 0 ? next.fault / now.fault : 0, all = find_norm(moved);
    out.displacement_residual = fading < 1 && all > 0 ? find_norm(q) / all * fading / (1 - fading) : 1;
    out.flows = is_steady(largest, next.fault);
    system_.to_nodes(q, last_motion_.displacement);
    last_motion_.strain = next.state.strain;
    for (std::size_t p = 0; p < last_motion_.strain.size(); ++p)
      for (std::size_t i = 0; i < 6; ++i) last_motion_.strain[p][i] -= now.state.strain[p][i];
    std::swap(now, next);
    viscosity = creep::relax(viscosity, solves);
  }
  out.flows = out.flows && !out.converged;
  end = std::move(now.state);
  return out;
}

template class SolidNewton<2>;
template class SolidNewton<3>;

}  // namespace talus::fem
