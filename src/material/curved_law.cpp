// SPDX-License-Identifier: MIT
#include "material/curved_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus::material {
namespace {

constexpr double kilo = 1e3;
/// Normal stress below which a power curve is replaced by its secant, which is weaker [Pa].
constexpr double least_stress = 100;
/// Iterations of the tangent, and the difference of strengths at which it has converged [-].
constexpr int most_tangents = 60;
constexpr double tolerance = 1e-10;

struct Principal {
  double s1, s3;
};
template <int NS>
Principal find_principal(const double* sigma) {
  if constexpr (NS == 4) {
    const PlanePrincipal<double> p(sigma);
    return {p.s1, p.s3};
  } else {
    static const CosineThird cosine;
    const SpacePrincipal<double> p(sigma, cosine);
    return {p.s1, p.s3};
  }
}

double find_sine(const StrengthTangent& t) {
  return t.tan_friction / std::hypot(1.0, t.tan_friction);
}

}  // namespace

double HoekBrownMass::find_major(double minor) const {
  return minor + intact_strength * std::pow(std::max(0.0, m * minor / intact_strength + s), a);
}

double HoekBrownMass::find_ratio(double minor) const {
  return 1 + a * m * std::pow(m * minor / intact_strength + s, a - 1);
}

StrengthTangent HoekBrownMass::find_tangent(double normal) const {
  // Balmer (1952): σ_n = σ3 + (σ1 - σ3)/(1 + dσ1/dσ3), solved for x = m σ3/σ_ci + s by Newton's method within a
  // bracket. σ_n rises with x, from the tensile strength at x = 0, where dσ1/dσ3 is infinite.
  constexpr double least = 1e-6;  // of s
  double low = least * s, high = m * std::max(0.0, normal) / intact_strength + s, x = 0.5 * (high - s) + s, excess = 0;
  for (int i = 0; i < 100; ++i) {
    const double power = std::pow(x, a);
    excess = a * m * power / x;  // dσ1/dσ3 - 1
    const double miss = (x - s) / m + power / (2 + excess) - normal / intact_strength,
                 slope = 1 / m + power / x * (2 * a + excess) / ((2 + excess) * (2 + excess));
    (miss < 0 ? low : high) = x;
    double next = x - miss / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double moved = std::abs(next - x);
    x = next;
    if (moved <= 1e-12 * x || high <= least * s) break;
  }
  const double minor = (x - s) * intact_strength / m, k = find_ratio(minor), root = std::sqrt(k);
  return {(find_major(minor) - k * minor) / (2 * root), (k - 1) / (2 * root)};
}

StrengthTangent PowerEnvelope::find_tangent(double normal) const {
  const double shifted = normal + shift, at = std::max(least_stress, shifted) / kilo,
               strength = kilo * factor * std::pow(at, exponent), secant = strength / (kilo * at),
               slope = exponent * secant;
  // The line through the shifted origin, or the tangent.
  if (shifted <= least_stress) return {cohesion + secant * shift, secant};
  return {cohesion + strength - slope * normal, slope};
}

StrengthTangent StrengthPairs::find_tangent(double normal_stress) const {
  const auto above =
      static_cast<std::size_t>(std::upper_bound(normal.begin(), normal.end(), normal_stress) - normal.begin());
  const std::size_t i = std::clamp<std::size_t>(above, 1, normal.size() - 1);
  const double slope = (shear[i] - shear[i - 1]) / (normal[i] - normal[i - 1]);
  return {shear[i] - slope * normal[i], slope};
}

StrengthTangent CurvedLaw::find_tangent(double normal) const {
  const StrengthTangent t = std::visit([&](const auto& e) { return e.find_tangent(normal); }, envelope_);
  return {t.cohesion / factor_, t.tan_friction / factor_};
}

double CurvedLaw::find_tension() const {
  return std::visit([](const auto& e) { return e.tensile_strength(); }, envelope_) / factor_;
}

bool CurvedLaw::is_within(double s1, double s3, double& normal) const {
  // The envelope is concave, so that the circle crosses it if it crosses any tangent. The nearest tangent touches at
  // the foot of the perpendicular from the centre.
  const double centre = -0.5 * (s1 + s3), radius = 0.5 * (s1 - s3);
  normal = centre;
  for (int i = 0; i < most_tangents; ++i) {
    const StrengthTangent t = find_tangent(normal);
    const double sine = find_sine(t), cosine = std::sqrt(1 - sine * sine),
                 distance = t.cohesion * cosine + centre * sine;
    if (distance < radius) return false;
    const double next = centre - distance * sine;
    if (std::abs(next - normal) <= tolerance * std::abs(distance)) break;
    normal = next;
  }
  return s1 <= find_tension();
}

template <int NS>
Response<double> CurvedLaw::update_point(double* sigma, const double* d_epsilon, double* state,
                                         const Surroundings<double>& given) const {
  double trial[NS];
  std::copy_n(sigma, NS, trial);
  add_elastic_increment<NS>(trial, d_epsilon);
  const Principal p = find_principal<NS>(trial);
  double normal = 0;
  Surroundings<double> around;
  around.gaps = given.gaps;
  // A gap must close first, which Mohr–Coulomb's update computes.
  const bool has_gap = given.gaps == Gaps::kept && state[1] > 0;
  if (is_within(p.s1, p.s3, normal) && !has_gap) {
    std::copy_n(trial, NS, sigma);
    return {false, 0.0, 0.0};
  }
  double result[NS], updated[state_size];
  Response<double> response{};
  for (int i = 0; i < most_tangents; ++i) {
    const StrengthTangent t = find_tangent(normal);
    const double friction = std::atan(t.tan_friction);
    const MohrCoulomb soil(
        *this, {std::max(0.0, t.cohesion), friction, std::atan(dilatancy_ratio_ * t.tan_friction), find_tension()});
    std::copy_n(sigma, NS, result);
    std::copy_n(state, state_size, updated);
    response = soil.update<NS>(result, d_epsilon, updated, true, around);
    const Principal now = find_principal<NS>(result);
    const double sine = std::sin(friction), next = -0.5 * (now.s1 + now.s3) - 0.5 * (now.s1 - now.s3) * sine;
    const StrengthTangent other = find_tangent(next);
    const double strength = other.cohesion + next * other.tan_friction,
                 excess = t.cohesion + next * t.tan_friction - strength;
    normal = next;
    if (std::abs(excess) <= tolerance * (std::abs(strength) + 1)) break;
  }
  std::copy_n(result, NS, sigma);
  std::copy_n(updated, state_size, state);
  return response;
}

template Response<double> CurvedLaw::update_point<4>(double*, const double*, double*,
                                                     const Surroundings<double>&) const;
template Response<double> CurvedLaw::update_point<6>(double*, const double*, double*,
                                                     const Surroundings<double>&) const;

}  // namespace talus::material
