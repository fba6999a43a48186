// SPDX-License-Identifier: MIT
#pragma once
// Second-order cone programs: the program and its solution, the algebra of one second-order cone in R^n (for n = 1 that
// of positive numbers), and the scaling of Nesterov and Todd. Formulas: L. Vandenberghe, The CVXOPT linear and
// quadratic cone program solvers (2010), sections 4 and 5.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace talus::bounds {

// A second-order cone program, and its outcome: a solution, a certificate that there is none, or the reason of a
// failure.

/// A sparse matrix stored by rows.
struct SparseRows {
  std::vector<int> first{0};  ///< index in `column` and `value` of the first entry of each row; one more at the end
  std::vector<int> column;    ///< increasing within a row
  std::vector<double> value;

  int count() const { return static_cast<int>(first.size()) - 1; }
  /// Returns the index of the first entry of a row; for the row after the last one, the number of entries.
  std::size_t begin(int row) const { return static_cast<std::size_t>(first[static_cast<std::size_t>(row)]); }
  void add(int at, double number) { column.push_back(at), value.push_back(number); }
  void end_row() { first.push_back(static_cast<int>(column.size())); }
};

/// Derivatives by the factor of safety of the entries and of the right-hand side of a row.
struct RowRate {
  int row = 0;
  double right = 0;
  std::vector<std::pair<int, double>> entries{};
};

/// Minimises qᵀx over all x and s with A x + s = b. The first rows are equations (s = 0), then follow the rows of the
/// cones: s ≥ 0 for a cone of one row, s₀ ≥ |(s₁, s₂, …)| for one of more. The dual program maximises −bᵀz with Aᵀz + q
/// = 0 and z in the same cones.
struct ConicProgram {
  int variables = 0;
  int equations = 0;
  std::vector<int> cones;     ///< number of rows of each
  std::vector<double> cost;   ///< q
  SparseRows rows;            ///< A
  std::vector<double> right;  ///< b
  /// Rows whose coefficients depend on the factor, other than those of the criterion of the soil.
  std::vector<RowRate> rates;

  /// Adds a row from entries in any order; entries of the same variable are summed. Clears `entries`.
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
  solved,      ///< x, s and z satisfy the tolerance
  infeasible,  ///< z is a certificate: Aᵀz = 0 and bᵀz = −1 with z in the cones, so that no x has A x + s = b
  unbounded,   ///< x is a certificate: A x + s = 0 and qᵀx = −1 with s in the cones
  stalled      ///< none of these; `why` gives the reason
};

struct ConicSolution {
  ConicEnd end = ConicEnd::stalled;
  std::vector<double> x, s, z;
  double primal = 0, dual = 0;  ///< qᵀx and −bᵀz
  int iterations = 0;
  /// Largest |A x + s − b| over 1 + |b|, largest |Aᵀz + q| over 1 + |q|, and |primal − dual| over 1 + the smaller of
  /// the two.
  double primal_residual = 0, dual_residual = 0, gap = 0;
  std::string why;
};

struct ConicOptions {
  double tolerance = 1e-6;   ///< limit of both residuals and of the gap
  double value_size = 1e-3;  ///< scale of qᵀx near zero, in the units of the solver
  double proof = 1e-8;       ///< of a certificate
  int most_iterations = 100;
};

using Part = std::span<const double>;
using MutablePart = std::span<double>;

inline double measure_tail(Part u) {
  double sum = 0;
  for (std::size_t i = 1; i < u.size(); ++i) sum += u[i] * u[i];
  return std::sqrt(sum);
}

inline double multiply(Part u, Part v) {
  double sum = 0;
  for (std::size_t i = 0; i < u.size(); ++i) sum += u[i] * v[i];
  return sum;
}

/// Returns u₀ − |u₁|, which is positive inside the cone and negative outside.
inline double measure_margin(Part u) {
  return u[0] - measure_tail(u);
}

/// Returns u₀² − |u₁|² without cancellation on the surface of the cone.
inline double find_determinant(Part u) {
  if (u.size() == 1) return u[0] * u[0];
  const double tail = measure_tail(u);
  return (u[0] - tail) * (u[0] + tail);
}

/// Returns the largest t with u + t d in the cone, for u inside it; infinity if the ray stays inside.
inline double find_step(Part u, Part d) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (u.size() == 1) return d[0] < 0 ? -u[0] / d[0] : never;
  // (u + t d)₀² = |(u + t d)₁|²: a t² + 2 b t + c = 0 with c > 0. The ray leaves the cone at the first positive root.
  const double a = find_determinant(d), c = find_determinant(u);
  double b = u[0] * d[0];
  for (std::size_t i = 1; i < u.size(); ++i) b -= u[i] * d[i];
  if (a >= 0 && b >= 0 && d[0] >= 0) return never;
  const double root = b * b - a * c;
  if (root < 0) return never;
  const double q = -b + (b < 0 ? std::sqrt(root) : -std::sqrt(root));
  const double one = q == 0 ? never : c / q, other = a == 0 ? never : q / a;
  double t = never;
  if (one > 0) t = one;
  if (other > 0) t = std::min(t, other);
  return t;
}

/// The scaling W = η [w₀ w₁ᵀ; w₁ I + w₁w₁ᵀ/(1 + w₀)] with W z = W⁻¹ s = λ and w₀² − |w₁|² = 1.
struct Scaling {
  double eta = 1;
  MutablePart w;

  /// Returns false unless s and z are inside the cone by more than rounding.
  bool set(Part s, Part z) {
    const double ds = find_determinant(s), dz = find_determinant(z);
    if (!(ds > 0 && dz > 0 && s[0] > 0 && z[0] > 0)) return false;
    eta = std::sqrt(std::sqrt(ds / dz));
    if (w.size() == 1) {
      w[0] = 1;
      return true;
    }
    const double rs = 1 / std::sqrt(ds), rz = 1 / std::sqrt(dz);
    const double gamma = std::sqrt(std::max(1.0, 0.5 * (1 + multiply(s, z) * rs * rz)));
    for (std::size_t i = 0; i < w.size(); ++i) w[i] = (s[i] * rs + (i == 0 ? 1 : -1) * z[i] * rz) / (2 * gamma);
    w[0] = std::sqrt(1 + measure_tail(w) * measure_tail(w));  // keeps w on the hyperboloid in spite of rounding
    return true;
  }
  /// Computes out = W u (`inverse`: W⁻¹ u); out may be u.
  void apply(Part u, bool inverse, MutablePart out) const {
    const double sign = inverse ? -1 : 1, size = inverse ? 1 / eta : eta;
    double tail = 0;
    for (std::size_t i = 1; i < u.size(); ++i) tail += w[i] * u[i];
    const double head = u[0], along = sign * head + tail / (1 + w[0]);
    out[0] = size * (w[0] * head + sign * tail);
    for (std::size_t i = 1; i < u.size(); ++i) out[i] = size * (u[i] + along * w[i]);
  }
  /// Computes out = W² u = η² (2 w (wᵀu) − J u) with J = diag(1, −1, …); `inverse`: W⁻² u, with J w in place of w.
  void apply_square(Part u, bool inverse, MutablePart out) const {
    const double sign = inverse ? -1 : 1, size = inverse ? 1 / (eta * eta) : eta * eta, head = u[0];
    double along = w[0] * head;
    for (std::size_t i = 1; i < u.size(); ++i) along += sign * w[i] * u[i];
    out[0] = size * (2 * along * w[0] - head);
    for (std::size_t i = 1; i < u.size(); ++i) out[i] = size * (2 * along * sign * w[i] + u[i]);
  }
};

/// Computes out = u ∘ v = (uᵀv, u₀v₁ + v₀u₁); out may not be u or v.
inline void join(Part u, Part v, MutablePart out) {
  out[0] = multiply(u, v);
  for (std::size_t i = 1; i < u.size(); ++i) out[i] = u[0] * v[i] + v[0] * u[i];
}

/// Computes out with u ∘ out = v; out may be v.
inline void divide(Part u, Part v, MutablePart out) {
  if (u.size() == 1) {
    out[0] = v[0] / u[0];
    return;
  }
  double tail = 0;
  for (std::size_t i = 1; i < u.size(); ++i) tail += u[i] * v[i];
  out[0] = (u[0] * v[0] - tail) / find_determinant(u);
  for (std::size_t i = 1; i < u.size(); ++i) out[i] = (v[i] - out[0] * u[i]) / u[0];
}

}  // namespace talus::bounds
