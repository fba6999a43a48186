// SPDX-License-Identifier: MIT
// The interior point iteration: equilibration, residuals, scalings, affine and combined direction, step.
#include "bounds/conic/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/progress.hpp"
#include "bounds/conic/kkt.hpp"

namespace talus::bounds {

// Ruiz' equilibration (CERFACS report 2001): each row and column is repeatedly divided by the root of its largest
// entry.

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

/// Gives the rows of one cone a common factor, as different ones would change the cone.
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

namespace {

using Vector = std::vector<double>;

double dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Computes out = A u.
void multiply(const SparseRows& a, const Vector& u, Vector& out) {
  out.assign(static_cast<std::size_t>(a.count()), 0);
  for (std::size_t r = 0; r < out.size(); ++r)
    for (auto k = static_cast<std::size_t>(a.first[r]); k < static_cast<std::size_t>(a.first[r + 1]); ++k)
      out[r] += a.value[k] * u[static_cast<std::size_t>(a.column[k])];
}

/// Computes out = Aᵀ u.
void multiply_transposed(const SparseRows& a, const Vector& u, std::size_t columns, Vector& out) {
  out.assign(columns, 0);
  for (std::size_t r = 0; r < u.size(); ++r)
    for (auto k = static_cast<std::size_t>(a.first[r]); k < static_cast<std::size_t>(a.first[r + 1]); ++k)
      out[static_cast<std::size_t>(a.column[k])] += a.value[k] * u[r];
}

/// A point of the homogeneous embedding, or a direction.
struct Point {
  Vector x, s, z;
  double tau = 0, kappa = 0;
};

class InteriorPoint {
 public:
  InteriorPoint(const ConicProgram& asked, const ConicOptions& options, const KktAccuracy& accuracy)
      : asked_(asked), options_(options), program_(asked), scale_(equilibrate(program_)), kkt_(program_, accuracy) {
    std::size_t row = static_cast<std::size_t>(program_.equations);
    for (const int size : program_.cones) {
      first_.push_back(row);
      row += static_cast<std::size_t>(size);
    }
    w_.assign(row, 0);
    for (std::size_t c = 0; c < program_.cones.size(); ++c)
      scalings_.push_back({1, MutablePart(w_).subspan(first_[c], static_cast<std::size_t>(program_.cones[c]))});
    const auto rows = static_cast<std::size_t>(program_.rows.count()),
               columns = static_cast<std::size_t>(program_.variables);
    for (Point* p : {&at_, &step_, &affine_}) p->x.assign(columns, 0), p->s.assign(rows, 0), p->z.assign(rows, 0);
  }

  ConicSolution run(const ConicSolution* start) {
    if (!(start ? begin_from(*start) : begin())) return end_stalled("the system of the first step has no solution");
    for (int i = 0; i < options_.most_iterations; ++i) {
      throw_if_interrupted();
      find_residuals();
      if (const auto end = judge(options_.tolerance, options_.proof)) return *end;
      ++iterations_;
      if (!scale()) return end_stalled("a point reached the surface of its cone");
      if (!kkt_.factorise(scalings_)) return end_stalled("the system of a step has no factors");
      if (!find_direction()) return end_stalled("the system of a step has no solution");
      if (!(length_ > 1e-8)) return end_stalled("the steps became too short");
      move();
    }
    find_residuals();
    return end_stalled(fmt::format("{} iterations were not enough", options_.most_iterations));
  }

 private:
  Part part(const Vector& v, std::size_t c) const {
    return Part(v).subspan(first_[c], static_cast<std::size_t>(program_.cones[c]));
  }
  MutablePart part(Vector& v, std::size_t c) const {
    return MutablePart(v).subspan(first_[c], static_cast<std::size_t>(program_.cones[c]));
  }

  /// Shifts u along the axes of the cones until its margin is at least one in every cone.
  void move_inside(Vector& u) const {
    double margin = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < scalings_.size(); ++c) margin = std::min(margin, measure_margin(part(u, c)));
    if (margin > 0.1 || scalings_.empty()) return;
    for (std::size_t c = 0; c < scalings_.size(); ++c) part(u, c)[0] += 1 - margin;
  }

  bool begin() {
    for (Scaling& w : scalings_) {
      std::fill(w.w.begin(), w.w.end(), 0.0);
      w.eta = 1, w.w[0] = 1;
    }
    if (!kkt_.factorise(scalings_)) return false;
    const Vector none_x(at_.x.size(), 0), none_z(at_.z.size(), 0);
    Vector unused(at_.x.size());
    // The smallest s with A x + s = b, and the smallest z with Aᵀz = −q.
    Vector cost = program_.cost;
    for (double& q : cost) q = -q;
    if (!kkt_.solve(none_x, program_.right, at_.x, at_.s) || !kkt_.solve(cost, none_z, unused, at_.z)) return false;
    for (double& s : at_.s) s = -s;
    std::fill_n(at_.s.begin(), program_.equations, 0.0);
    move_inside(at_.s), move_inside(at_.z);
    at_.tau = at_.kappa = 1;
    return true;
  }

  bool begin_from(const ConicSolution& start) {
    if (start.x.size() != at_.x.size() || start.z.size() != at_.z.size()) return begin();
    for (std::size_t j = 0; j < at_.x.size(); ++j) at_.x[j] = start.x[j] / scale_.column[j] * scale_.right;
    for (std::size_t r = 0; r < at_.z.size(); ++r) {
      at_.s[r] = start.s[r] * scale_.row[r] * scale_.right;
      at_.z[r] = start.z[r] / scale_.row[r] * scale_.cost;
    }
    // A solution lies on the surfaces of the cones. It is shifted inside by a fraction of its size, so that no step
    // starts from a corner.
    constexpr double inside = 0.03;
    for (Vector* u : {&at_.s, &at_.z}) {
      const double least = inside * (find_largest(*u) + 1e-3);
      for (std::size_t c = 0; c < scalings_.size(); ++c)
        part(*u, c)[0] += std::max(0.0, least - measure_margin(part(*u, c)));
    }
    at_.tau = 1;
    at_.kappa = std::max(1e-3, find_mean());
    return true;
  }

  double find_mean() const {
    return (dot(at_.s, at_.z) + at_.tau * at_.kappa) / (static_cast<double>(scalings_.size()) + 1);
  }

  /// Computes rx = Aᵀz + qτ, rz = A x + s − bτ, rt = qᵀx + bᵀz + κ.
  void find_residuals() {
    multiply_transposed(program_.rows, at_.z, at_.x.size(), atz_);
    multiply(program_.rows, at_.x, ax_);
    rx_ = atz_, rz_ = ax_;
    for (std::size_t j = 0; j < rx_.size(); ++j) rx_[j] += program_.cost[j] * at_.tau;
    for (std::size_t r = 0; r < rz_.size(); ++r) rz_[r] += at_.s[r] - program_.right[r] * at_.tau;
    rt_ = dot(program_.cost, at_.x) + dot(program_.right, at_.z) + at_.kappa;
    mean_ = find_mean();
  }

  bool scale() {
    lambda_.assign(at_.s.size(), 0);
    for (std::size_t c = 0; c < scalings_.size(); ++c) {
      if (!scalings_[c].set(part(at_.s, c), part(at_.z, c))) return false;
      scalings_[c].apply(part(at_.z, c), false, part(lambda_, c));
    }
    return true;
  }

  /// Computes a direction for the right-hand sides (1 − centring) times the residuals, ds, and dk.
  bool find_direction(double centring, const Vector& ds, double dk, Point& d) {
    const double part_of = 1 - centring;
    Vector f = rx_, g = rz_;
    for (double& v : f) v *= -part_of;
    for (std::size_t r = 0; r < g.size(); ++r) g[r] = ds[r] - part_of * g[r];
    if (!kkt_.solve(f, g, d.x, d.z)) return false;
    const double above = part_of * rt_ - dk / at_.tau + dot(program_.cost, d.x) + dot(program_.right, d.z);
    const double below = at_.kappa / at_.tau - dot(program_.cost, constant_x_) - dot(program_.right, constant_z_);
    d.tau = above / below;
    for (std::size_t j = 0; j < d.x.size(); ++j) d.x[j] += d.tau * constant_x_[j];
    for (std::size_t r = 0; r < d.z.size(); ++r) d.z[r] += d.tau * constant_z_[r];
    find_slack_step(ds, d);
    d.kappa = -(dk + at_.kappa * d.tau) / at_.tau;
    return std::isfinite(d.tau);
  }

  /// Computes Δs = −ds − H Δz.
  void find_slack_step(const Vector& ds, Point& d) const {
    std::fill_n(d.s.begin(), program_.equations, 0.0);
    for (std::size_t c = 0; c < scalings_.size(); ++c) {
      const MutablePart own = part(d.s, c);
      scalings_[c].apply_square(part(d.z, c), false, own);
      const Part other = part(ds, c);
      for (std::size_t i = 0; i < own.size(); ++i) own[i] = -other[i] - own[i];
    }
  }

  double find_length(const Point& d) const {
    double length = 1 / 0.99;
    if (d.tau < 0) length = std::min(length, -at_.tau / d.tau);
    if (d.kappa < 0) length = std::min(length, -at_.kappa / d.kappa);
    for (std::size_t c = 0; c < scalings_.size(); ++c)
      length = std::min({length, find_step(part(at_.s, c), part(d.s, c)), find_step(part(at_.z, c), part(d.z, c))});
    return 0.99 * length;
  }

  bool find_direction() {
    Vector cost = program_.cost;
    for (double& q : cost) q = -q;
    if (!kkt_.solve(cost, program_.right, constant_x_, constant_z_)) return false;
    if (!find_direction(0, at_.s, at_.kappa * at_.tau, affine_)) return false;
    const double length = find_length(affine_);
    const double centring = std::clamp(std::pow(1 - length, 3), 1e-6, 1.0);
    Vector ds(at_.s.size(), 0), a, b, product;
    for (std::size_t c = 0; c < scalings_.size(); ++c) {
      const auto size = static_cast<std::size_t>(program_.cones[c]);
      a.resize(size), b.resize(size), product.resize(size);
      scalings_[c].apply(part(affine_.s, c), true, a);
      scalings_[c].apply(part(affine_.z, c), false, b);
      join(a, b, product);
      const Part l = part(lambda_, c);
      join(l, l, a);
      for (std::size_t i = 0; i < size; ++i) product[i] += a[i];
      product[0] -= centring * mean_;
      divide(l, product, product);
      scalings_[c].apply(product, false, part(ds, c));
    }
    const double dk = at_.kappa * at_.tau + affine_.kappa * affine_.tau - centring * mean_;
    if (!find_direction(centring, ds, dk, step_)) return false;
    length_ = std::min(1.0, find_length(step_));
    return true;
  }

  void move() {
    for (std::size_t j = 0; j < at_.x.size(); ++j) at_.x[j] += length_ * step_.x[j];
    for (std::size_t r = 0; r < at_.z.size(); ++r) at_.z[r] += length_ * step_.z[r], at_.s[r] += length_ * step_.s[r];
    at_.tau += length_ * step_.tau, at_.kappa += length_ * step_.kappa;
    // Points are defined up to a positive factor; they are scaled so that the larger of τ and κ is one.
    const double size = 1 / std::max(at_.tau, at_.kappa);
    for (Vector* u : {&at_.x, &at_.s, &at_.z})
      for (double& v : *u) v *= size;
    at_.tau *= size, at_.kappa *= size;
  }

  /// Returns the point divided by `by`, in the units of the given program.
  ConicSolution read(double by) const {
    ConicSolution r;
    r.x.resize(at_.x.size()), r.s.resize(at_.s.size()), r.z.resize(at_.z.size());
    for (std::size_t j = 0; j < r.x.size(); ++j) r.x[j] = at_.x[j] * scale_.column[j] / (scale_.right * by);
    for (std::size_t i = 0; i < r.z.size(); ++i) {
      r.s[i] = at_.s[i] / (scale_.row[i] * scale_.right * by);
      r.z[i] = at_.z[i] * scale_.row[i] / (scale_.cost * by);
    }
    r.iterations = iterations_;
    r.primal = dot(asked_.cost, r.x), r.dual = -dot(asked_.right, r.z);
    return r;
  }

  std::optional<ConicSolution> judge(double tolerance, double proof) const {
    const double tau = at_.tau;
    double dual_residual = 0, primal_residual = 0;
    for (double v : rx_) dual_residual = std::max(dual_residual, std::abs(v) / tau);
    for (double v : rz_) primal_residual = std::max(primal_residual, std::abs(v) / tau);
    const double primal = dot(program_.cost, at_.x) / tau, dual = -dot(program_.right, at_.z) / tau;
    // The largest entries of cost and right-hand side are one after the equilibration.
    dual_residual /= 1 + find_largest(atz_) / tau, primal_residual /= 1 + find_largest(ax_) / tau;
    const double gap = std::abs(primal - dual) / (options_.value_size + std::min(std::abs(primal), std::abs(dual)));
    auto fill = [&](ConicSolution r, ConicEnd end) {
      r.end = end, r.primal_residual = primal_residual, r.dual_residual = dual_residual, r.gap = gap;
      return r;
    };
    if (tau > 1e-12 && primal_residual <= tolerance && dual_residual <= tolerance && gap <= tolerance)
      return fill(read(tau), ConicEnd::solved);
    const double bz = dot(program_.right, at_.z), qx = dot(program_.cost, at_.x);
    if (bz < 0 && find_largest(atz_) <= -proof * bz) return fill(read_proof(-bz), ConicEnd::infeasible);
    if (qx < 0) {
      double left = 0;
      for (std::size_t r = 0; r < ax_.size(); ++r) left = std::max(left, std::abs(ax_[r] + at_.s[r]));
      if (left <= -proof * qx) return fill(read_proof(-qx), ConicEnd::unbounded);
    }
    return {};
  }

  /// Returns a certificate, scaled to size one in the units of the given program.
  ConicSolution read_proof(double by) const {
    ConicSolution r = read(by);
    const double size = r.dual > 0 && r.dual >= -r.primal ? r.dual : -r.primal;
    if (size > 0)
      for (Vector* u : {&r.x, &r.s, &r.z})
        for (double& v : *u) v /= size;
    return r;
  }

  /// Accepts the last point if it is within 1000 times the tolerances; otherwise reports why the iteration stalled.
  ConicSolution end_stalled(const std::string& why) const {
    if (rx_.size() == at_.x.size())
      if (auto near = judge(1e3 * options_.tolerance, 1e3 * options_.proof)) return *near;
    ConicSolution r = read(std::max(at_.tau, 1e-300));
    r.why = why;
    return r;
  }

  const ConicProgram& asked_;
  ConicOptions options_;
  ConicProgram program_;
  Equilibration scale_;
  Kkt kkt_;
  std::vector<std::size_t> first_;
  Vector w_, lambda_, atz_, ax_, rx_, rz_, constant_x_, constant_z_;
  double rt_ = 0, mean_ = 0, length_ = 0;
  std::vector<Scaling> scalings_;
  Point at_, step_, affine_;
  int iterations_ = 0;
};

}  // namespace

ConicSolution solve(const ConicProgram& program, const ConicOptions& options, const ConicSolution* start) {
  ConicSolution found = InteriorPoint(program, options, quick_accuracy).run(start);
  if (found.end != ConicEnd::stalled) return found;
  const int spent = found.iterations;
  found = InteriorPoint(program, options, careful_accuracy).run(start);
  found.iterations += spent;
  return found;
}

}  // namespace talus::bounds
