// SPDX-License-Identifier: MIT
// Implicit return of soil with bedding planes. With N the tractions of a plane and x its plastic slip and opening over
// the step, the stress is that of the soil for the strain Δε - Nᵀx, and x must be the return of the tractions:
//
//   r(x) = N σ(Δε - Nᵀx) - P(N σ(Δε - Nᵀx) + D x) = 0,   D = N C Nᵀ = diag(μ, λ+2μ)
//
// P returns tractions to the strength of the planes. Both strengths then hold at one stress, and both plastic strains
// belong to it (Koiter 1953). Returns to the two surfaces in turn, each from the last stress, end within both, but
// their plastic strains belong to the stresses between: flow is not associated even with ψ = φ, and equilibrium is
// missed.
//
// Newton's method solves the equation. Where a step does not halve the residual, x + D⁻¹r replaces it, which returns to
// the planes and to the soil in turn from the trial stress less the plastic strain of the other (Dykstra 1983, J. Am.
// Stat. Assoc. 78, 837) and converges for associated flow.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/dual.hpp"
#include "material/directed_strength.hpp"

namespace talus::material {
namespace {

/// Components of the traction: along the plane, across the section (NS = 6), normal to the plane.
template <int NS>
constexpr std::size_t tractions = NS == 4 ? 2 : 3;

template <std::size_t N>
using Vector = std::array<double, N>;
template <std::size_t N, std::size_t M>
using Matrix = std::array<std::array<double, M>, N>;

/// Solves A X = B by elimination with pivots; rows of a vanishing pivot have X = 0.
template <std::size_t N, std::size_t M>
void solve_small(Matrix<N, N> a, Matrix<N, M>& b) {
  double largest = 0;
  for (const auto& row : a)
    for (const double v : row) largest = std::max(largest, std::abs(v));
  const double least = 1e-12 * largest;
  for (std::size_t k = 0; k < N; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < N; ++i)
      if (std::abs(a[i][k]) > std::abs(a[best][k])) best = i;
    std::swap(a[k], a[best]);
    std::swap(b[k], b[best]);
    if (std::abs(a[k][k]) <= least) continue;
    for (std::size_t i = k + 1; i < N; ++i) {
      const double f = a[i][k] / a[k][k];
      for (std::size_t j = k; j < N; ++j) a[i][j] -= f * a[k][j];
      for (std::size_t j = 0; j < M; ++j) b[i][j] -= f * b[k][j];
    }
  }
  for (std::size_t k = N; k-- > 0;)
    for (std::size_t j = 0; j < M; ++j) {
      for (std::size_t i = k + 1; i < N; ++i) b[k][j] -= a[k][i] * b[i][j];
      b[k][j] = std::abs(a[k][k]) > least ? b[k][j] / a[k][k] : 0;
    }
}

template <std::size_t N>
double compute_norm(const Vector<N>& r) {
  double sum = 0;
  for (const double v : r) sum += v * v;
  return std::sqrt(sum);
}

/// Tractions on the strength of the planes and their derivative by the trial tractions.
template <std::size_t N>
struct ReturnedTractions {
  Vector<N> now;
  Matrix<N, N> slope;
};

/// The cone |τ| + σ_n tan φ = c and its apex. Tension is limited by the rock, on planes of all directions.
template <std::size_t N>
ReturnedTractions<N> return_tractions(const MohrCoulombStrength& planes, double mu, double stiffness,
                                      const Vector<N>& trial) {
  constexpr std::size_t n = N - 1;  // the normal component
  ReturnedTractions<N> out{trial, {}};
  const double friction = std::tan(planes.friction_angle), dilation = std::tan(planes.dilatancy_angle);
  const double shear = N == 2 ? std::abs(trial[0]) : std::hypot(trial[0], trial[1]);
  const double hardness = mu + stiffness * friction * dilation;
  const double slip = (shear + trial[n] * friction - planes.cohesion) / hardness;
  if (!(slip > 0)) {
    for (std::size_t i = 0; i < N; ++i) out.slope[i][i] = 1;
    return out;
  }
  if (!(shear > mu * slip)) {  // only with friction, as c >= 0
    out.now = {};
    out.now[n] = planes.cohesion / friction;
    return out;
  }
  const double left = (shear - mu * slip) / shear, by_shear = 1 - mu / hardness;
  out.now[n] -= stiffness * dilation * slip;
  out.slope[n][n] = 1 - stiffness * dilation * friction / hardness;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = trial[i] / shear;
    out.now[i] *= left;
    out.slope[i][n] = -mu * friction / hardness * at, out.slope[n][i] = -stiffness * dilation / hardness * at;
    for (std::size_t j = 0; j < n; ++j) {
      const double square = at * trial[j] / shear;
      out.slope[i][j] = left * ((i == j ? 1 : 0) - square) + by_shear * square;
    }
  }
  return out;
}

/// Returns the tractions of a stress, or the strain of slip and opening by its columns.
template <int NS>
Matrix<tractions<NS>, NS> make_projection(double c, double s) {
  Matrix<tractions<NS>, NS> p{};
  constexpr std::size_t n = tractions<NS> - 1;
  p[0][0] = -s * c, p[0][1] = s * c, p[0][3] = c * c - s * s;
  p[n][0] = s * s, p[n][1] = c * c, p[n][3] = -2 * s * c;
  if constexpr (NS == 6) p[1][4] = c, p[1][5] = -s;
  return p;
}

/// Iterations of one point.
template <int NS>
class BeddingReturn {
 public:
  static constexpr std::size_t N = tractions<NS>, S = NS;

  BeddingReturn(const MohrCoulomb& soil, const MohrCoulombStrength& planes, const Matrix<N, S>& projection,
                const double* sigma, const double* d_epsilon, const double* state)
      : soil_(soil), planes_(planes), projection_(projection), lambda_(soil.elastic().lambda), mu_(soil.elastic().mu) {
    std::copy_n(sigma, NS, sigma_.begin());
    std::copy_n(d_epsilon, NS, strain_.begin());
    std::copy_n(state, MohrCoulomb::state_size, state_.begin());
    old_ = apply(projection_, sigma_);
  }

  struct Point {
    Vector<N> slip{};  ///< x: plastic slips and opening [-]
    Vector<S> sigma;
    Vector<MohrCoulomb::state_size> state;
    Response<double> response;
    Matrix<S, S> soil_tangent;
    Vector<N> traction, residual;
    Matrix<N, N> return_slope;
    double norm;  ///< of the residual [Pa]
  };

  /// Solves for the slip, from none or from that of an elastic rock. Returns the point with the least residual.
  Point solve() const {
    const Point first = solve_from({});
    if (first.norm <= enough()) return first;
    const Point second = solve_from(compute_elastic_slip());
    return second.norm < first.norm ? second : first;
  }

  /// Derivative of the stress by the strain, symmetric for associated flow [Pa].
  Matrix<S, S> compute_tangent(const Point& at) const {
    Matrix<N, S> moved{};  // (I - P') N C of the soil
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t k = 0; k < N; ++k) {
        const double weight = (i == k ? 1 : 0) - at.return_slope[i][k];
        for (std::size_t j = 0; j < S; ++j)
          for (std::size_t l = 0; l < S; ++l) moved[i][j] += weight * projection_[k][l] * at.soil_tangent[l][j];
      }
    solve_small(compute_jacobian(at), moved);
    Matrix<S, S> tangent = at.soil_tangent;
    for (std::size_t i = 0; i < S; ++i)
      for (std::size_t l = 0; l < S; ++l)
        for (std::size_t k = 0; k < N; ++k)
          for (std::size_t j = 0; j < S; ++j) tangent[i][j] -= at.soil_tangent[i][l] * projection_[k][l] * moved[k][j];
    return tangent;
  }

  /// Adds the flow of the planes to the response and the plastic strain.
  void add_planes(Point& at) const {
    double slip = 0, work = 0;
    for (std::size_t k = 0; k < N; ++k) {
      work += 0.5 * (old_[k] + at.traction[k]) * at.slip[k];
      if (k + 1 < N) slip += at.slip[k] * at.slip[k];
    }
    const double opening = at.slip[N - 1];
    at.state[0] += std::sqrt(slip / 3 + 4.0 / 9 * opening * opening);
    at.response.any_plastic = true;
    at.response.plastic_dilation += opening;
    at.response.dissipation += work;
  }

 private:
  static constexpr int most_iterations = 100;
  static constexpr double good_fraction = 0.5;  ///< of the residual, at which a step of Newton's method is accepted

  double enough() const { return 1e-12 * mu_; }

  Point solve_from(const Vector<N>& start) const {
    Point at = evaluate(start), best = at;
    for (int i = 0; i < most_iterations && best.norm > enough(); ++i) {
      Matrix<N, 1> step;
      for (std::size_t k = 0; k < N; ++k) step[k][0] = at.residual[k];
      solve_small(compute_jacobian(at), step);
      Vector<N> x = at.slip;
      for (std::size_t k = 0; k < N; ++k) x[k] += step[k][0];
      Point next = evaluate(x);
      if (!(next.norm < good_fraction * best.norm)) {
        x = at.slip;
        for (std::size_t k = 0; k < N; ++k) x[k] += at.residual[k] / stiffness(k);
        next = evaluate(x);
      }
      at = next;
      if (at.norm < best.norm) best = at;
    }
    return best;
  }

  Vector<N> compute_elastic_slip() const {
    Vector<S> trial = sigma_;
    soil_.elastic().template add_elastic_increment<NS>(trial.data(), strain_.data());
    const Vector<N> traction = apply(projection_, trial),
                    now = return_tractions<N>(planes_, mu_, lambda_ + 2 * mu_, traction).now;
    Vector<N> x;
    for (std::size_t k = 0; k < N; ++k) x[k] = (traction[k] - now[k]) / stiffness(k);
    return x;
  }

  static Vector<N> apply(const Matrix<N, S>& rows, const Vector<S>& v) {
    Vector<N> sum{};
    for (std::size_t k = 0; k < N; ++k)
      for (std::size_t i = 0; i < S; ++i) sum[k] += rows[k][i] * v[i];
    return sum;
  }
  double stiffness(std::size_t k) const { return k + 1 < N ? mu_ : lambda_ + 2 * mu_; }

  Point evaluate(const Vector<N>& x) const {
    Point p;
    p.slip = x;
    using T = Dual<NS>;
    std::array<T, S> sigma, strain;
    std::array<T, MohrCoulomb::state_size> state;
    for (std::size_t i = 0; i < S; ++i) {
      double d = strain_[i];
      for (std::size_t k = 0; k < N; ++k) d -= projection_[k][i] * x[k];
      sigma[i] = T(sigma_[i]);
      strain[i] = T::variable(d, static_cast<int>(i));
    }
    for (std::size_t i = 0; i < state.size(); ++i) state[i] = T(state_[i]);
    const auto response = soil_.update<NS, T>(sigma.data(), strain.data(), state.data(), true);
    p.response = {response.any_plastic, response.plastic_dilation.value, response.dissipation.value,
                  response.opened.value};
    for (std::size_t i = 0; i < S; ++i) {
      p.sigma[i] = sigma[i].value;
      for (std::size_t j = 0; j < S; ++j) p.soil_tangent[i][j] = sigma[i].slope[static_cast<int>(j)];
    }
    for (std::size_t i = 0; i < state.size(); ++i) p.state[i] = state[i].value;
    p.traction = apply(projection_, p.sigma);
    Vector<N> trial = p.traction;
    for (std::size_t k = 0; k < N; ++k) trial[k] += stiffness(k) * x[k];
    const auto returned = return_tractions<N>(planes_, mu_, lambda_ + 2 * mu_, trial);
    for (std::size_t k = 0; k < N; ++k) p.residual[k] = p.traction[k] - returned.now[k];
    p.return_slope = returned.slope;
    p.norm = compute_norm(p.residual);
    return p;
  }

  /// -∂r/∂x = (I - P') N C Nᵀ + P' D, with C of the soil.
  Matrix<N, N> compute_jacobian(const Point& at) const {
    Matrix<N, N> along{}, sum{};
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j)
        for (std::size_t k = 0; k < S; ++k)
          for (std::size_t l = 0; l < S; ++l)
            along[i][j] += projection_[i][k] * at.soil_tangent[k][l] * projection_[j][l];
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j) {
        sum[i][j] = at.return_slope[i][j] * stiffness(j);
        for (std::size_t k = 0; k < N; ++k) sum[i][j] += ((i == k ? 1 : 0) - at.return_slope[i][k]) * along[k][j];
      }
    return sum;
  }

  const MohrCoulomb& soil_;
  const MohrCoulombStrength& planes_;
  const Matrix<N, S>& projection_;
  double lambda_, mu_;
  Vector<S> sigma_, strain_;
  Vector<MohrCoulomb::state_size> state_;
  Vector<N> old_;  ///< tractions before the step [Pa]
};

}  // namespace

template <int NS>
bool Bedding::exceeds_planes(const double* sigma) const {
  const double tolerance = 1e-12 * mu, c = along_[0], s = along_[1];
  const double normal = s * s * sigma[0] + c * c * sigma[1] - 2 * s * c * sigma[3];
  const double along = s * c * (sigma[1] - sigma[0]) + (c * c - s * s) * sigma[3];
  const double across = NS == 6 ? c * sigma[4] - s * sigma[5] : 0;
  return std::hypot(along, across) + normal * std::tan(planes_.friction_angle) > planes_.cohesion + tolerance;
}

template <int NS>
Response<double> Bedding::update_coherent(double* sigma, const double* d_epsilon, double* state,
                                          double* tangent) const {
  std::array<double, NS> before, end;
  std::array<double, state_size> end_state;
  std::copy_n(sigma, NS, before.begin());
  std::copy_n(sigma, NS, end.begin());
  std::copy_n(state, state_size, end_state.begin());
  const Response<double> plain = soil_.update<NS>(end.data(), d_epsilon, end_state.data(), true);
  const bool slides = exceeds_planes<NS>(end.data());
  if (!slides && !tangent) {
    std::copy(end.begin(), end.end(), sigma);
    std::copy(end_state.begin(), end_state.end(), state);
    return plain;
  }
  const auto projection = make_projection<NS>(along_[0], along_[1]);
  const BeddingReturn<NS> solver(soil_, planes_, projection, before.data(), d_epsilon, state);
  auto point = solver.solve();
  if (tangent) {
    const auto rows = solver.compute_tangent(point);
    for (std::size_t i = 0; i < NS; ++i) std::copy(rows[i].begin(), rows[i].end(), tangent + i * NS);
  }
  if (slides) solver.add_planes(point);
  std::copy(point.sigma.begin(), point.sigma.end(), sigma);
  std::copy(point.state.begin(), point.state.end(), state);
  return point.response;
}

template <int NS>
Response<double> Bedding::update_point(double* sigma, const double* d_epsilon, double* state,
                                       const Surroundings<double>& given, double* tangent) const {
  if (given.gaps == Gaps::kept) {
    const AfterClosing<NS, double> rest(*this, sigma, d_epsilon, state[1], true);
    Response<double> response = update_coherent<NS>(sigma, rest.strain, state, tangent);
    rest.finish(response, state + 1, true);
    return response;
  }
  Response<double> response = update_coherent<NS>(sigma, d_epsilon, state, tangent);
  if (given.gaps == Gaps::none && response.any_plastic) response.gap = state[1] = response.opened;
  return response;
}

template Response<double> Bedding::update_point<4>(double*, const double*, double*, const Surroundings<double>&,
                                                   double*) const;
template Response<double> Bedding::update_point<6>(double*, const double*, double*, const Surroundings<double>&,
                                                   double*) const;

}  // namespace talus::material
