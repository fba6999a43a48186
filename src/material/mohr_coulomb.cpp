// SPDX-License-Identifier: MIT
#include "material/mohr_coulomb.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/units.hpp"

namespace talus::material {
namespace {

using Vector = std::array<double, 3>;

double product(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<double, 4> invert(double a11, double a12, double a21, double a22) {
  const double det = a11 * a22 - a12 * a21;
  return {a22 / det, -a12 / det, -a21 / det, a11 / det};
}

}  // namespace

MohrCoulombStrength MohrCoulombStrength::reduced(double factor) const {
  const double phi = std::atan(std::tan(friction_angle) / factor);
  return {cohesion / factor, phi, std::min(dilatancy_angle, phi), tensile_strength / factor};
}

MohrCoulombStrength MohrCoulombStrength::changed(const StrengthChange& change) const {
  MohrCoulombStrength strength = *this;
  if (change.cohesion) strength.cohesion = *change.cohesion;
  return change.factor == 1 ? strength : strength.reduced(change.factor);
}

MohrCoulomb MohrCoulomb::make(const Input& in, const StrengthChange& change) {
  return {LinearElastic::make(in), in.get<MohrCoulombStrength>().changed(change)};
}

void MohrCoulombStrength::check(const SoilFindings& findings) const {
  const double degree = units::get_si_factor("deg");
  const bool has_angle = findings.is_sound("friction_angle");
  if (has_angle && findings.is_sound("dilatancy_angle") && dilatancy_angle > friction_angle)
    findings.add(
        "dilatancy_angle",
        fmt::format("'dilatancy_angle' is {:.6g} deg; it must not be greater than the friction angle, {:.6g} deg",
                    dilatancy_angle / degree, friction_angle / degree));
  // For φ = 0 the yield surface has no apex, so the tensile strength is the only limit of tension.
  if (!has_angle || !findings.is_sound("cohesion") || !findings.is_sound("tensile_strength") || friction_angle <= 0)
    return;
  const double apex = cohesion / std::tan(friction_angle);
  // An apex that was written with six digits passes: all laws limit tension to the apex itself.
  if (tensile_strength > apex * (1 + 1e-5))
    findings.add(
        "tensile_strength",
        fmt::format("'tensile_strength' is {}; it must not be above the apex of the yield surface, "
                    "cohesion/tan(friction_angle) = {}",
                    format_value(tensile_strength, findings.units.stress), format_value(apex, findings.units.stress)));
}

Properties MohrCoulombStrength::list_properties() const {
  Properties list;
  const auto add = [&](const char* key, const char* title, const char* symbol, ShownAs shown_as,
                       double MohrCoulombStrength::*value) {
    list.push_back({key, title, symbol, shown_as, this->*value,
                    [given = *this, value](double factor) { return given.reduced(factor).*value; }});
  };
  add("cohesion", "cohesion", "c", ShownAs::stress, &MohrCoulombStrength::cohesion);
  add("friction_angle", "angle of internal friction", "φ", ShownAs::angle, &MohrCoulombStrength::friction_angle);
  add("dilatancy_angle", "angle of dilatancy", "ψ", ShownAs::angle, &MohrCoulombStrength::dilatancy_angle);
  add("tensile_strength", "tensile strength", "σ_t", ShownAs::stress, &MohrCoulombStrength::tensile_strength);
  return list;
}

void MohrCoulombStrength::divide(PartialDivision& division) {
  const bool undrained = friction_angle == 0;
  division.divide(cohesion, undrained ? division.undrained : division.cohesion,
                  undrained ? "undrained shear strength" : "cohesion", undrained ? "c_u" : "c'", "kPa", 1e3);
  division.divide(tensile_strength, undrained ? division.undrained : division.cohesion, "tensile strength", "σ_t",
                  "kPa", 1e3);
  division.divide_angle(friction_angle, division.friction, "friction angle", "φ'");
  if (dilatancy_angle > friction_angle)  // ψ <= φ must also hold after the division
    division.divide_angle(dilatancy_angle, std::tan(dilatancy_angle) / std::tan(friction_angle), "dilatancy angle",
                          "ψ");
}

void MohrCoulomb::check(const Input& in, const SoilFindings& findings) {
  in.get<MohrCoulombStrength>().check(findings);
}

Properties MohrCoulomb::list_properties(const Input& in) {
  Properties list = in.get<MohrCoulombStrength>().list_properties();
  if (const double gradient = in.get<CohesionGradient>().cohesion_gradient; gradient != 0)
    list.push_back(
        {"cohesion_gradient", "growth of the cohesion with depth", "dc/dz", ShownAs::stress_per_length, gradient, {}});
  return list;
}

SliceStrength MohrCoulomb::find_slice_strength(const Input& in) {
  const MohrCoulombStrength& s = in.get<MohrCoulombStrength>();
  const CohesionGradient& g = in.get<CohesionGradient>();
  return {s.cohesion, s.friction_angle, g.cohesion_gradient, g.cohesion_level, nullptr};
}

void MohrCoulomb::divide(const Input::Changeable& in, PartialDivision& division) {
  MohrCoulombStrength& s = in.get<MohrCoulombStrength>();
  const double factor = s.friction_angle == 0 ? division.undrained : division.cohesion;
  s.divide(division);
  division.divide(in.get<CohesionGradient>().cohesion_gradient, factor, "growth of the cohesion with depth", "dc/dz",
                  "kPa/m", 1e3);
}

MohrCoulomb::MohrCoulomb(const LinearElastic& elastic, const MohrCoulombStrength& strength)
    : elastic_(elastic), strength_(strength) {
  const double sin_phi = std::sin(strength.friction_angle), sin_psi = std::sin(strength.dilatancy_angle);
  k_ = (1 + sin_phi) / (1 - sin_phi);
  const double m = (1 + sin_psi) / (1 - sin_psi);
  intercept_per_cohesion_ = 2 * std::sqrt(k_);
  bounds_.intercept = 2 * strength.cohesion * std::sqrt(k_);
  // Round-off of a trial stress is about 1e-16 times modulus times strain; 1e-12 μ is far above it and far below any
  // relevant stress.
  tolerance_ = 1e-12 * elastic.mu;
  const double apex = k_ > 1 ? bounds_.intercept / (k_ - 1) : strength.tensile_strength;
  bounds_.tension = std::min(strength.tensile_strength, apex);
  bounds_.tension_limit = bounds_.tension + tolerance_;
  // For φ = 0 there is no apex; the largest finite number instead of infinity avoids 0·∞ = NaN.
  apex_per_intercept_ = k_ > 1 ? 1 / (k_ - 1) : std::numeric_limits<double>::max();

  const auto stiffness = [&](const Vector& b) {
    const double volumetric = elastic.lambda * (b[0] + b[1] + b[2]);
    return Vector{volumetric + 2 * elastic.mu * b[0], volumetric + 2 * elastic.mu * b[1],
                  volumetric + 2 * elastic.mu * b[2]};
  };
  // Normals of the yield planes (1,3), (1,2), (2,3), and the plastic directions multiplied by the elastic stiffness.
  const Vector a13{k_, 0, -1}, a12{k_, -1, 0}, a23{0, k_, -1};
  const Vector c13 = stiffness({m, 0, -1}), c12 = stiffness({m, -1, 0}), c23 = stiffness({0, m, -1});
  for (std::size_t i = 0; i < 3; ++i) {
    plane_[i] = c13[i] / product(a13, c13);
    shear_direction_[i] = c13[i];
  }
  const auto make_edge = [&](const Vector& a, const Vector& c) {
    Edge edge{};
    const auto inverse = invert(product(a13, c13), product(a13, c), product(a, c13), product(a, c));
    std::copy(inverse.begin(), inverse.end(), edge.inverse);
    std::copy(c13.begin(), c13.end(), edge.first);
    std::copy(c.begin(), c.end(), edge.second);
    return edge;
  };
  edge_low_ = make_edge(a12, c12);
  edge_high_ = make_edge(a23, c23);
  const auto corner = invert(c13[0], elastic.lambda + 2 * elastic.mu, c13[2], elastic.lambda);
  std::copy(corner.begin(), corner.end(), corner_inverse_);

  // f = (s1-s3) + (s1+s3) sinφ - 2c cosφ with s1-s3 <= 2√J2 and |s1+s3-2p| <= 2√(J2/3) bounds f from above by the cone.
  const double scale = 2 + 2 / std::sqrt(3.0) * sin_phi;
  cone_slope_ = 2 * sin_phi / scale;
  cone_per_cohesion_ = 2 * std::cos(strength.friction_angle) / scale;
  bounds_.cone_offset = 2 * strength.cohesion * std::cos(strength.friction_angle) / scale;
  compliance_trace_ = elastic.lambda / (3 * elastic.lambda + 2 * elastic.mu);
  half_over_mu_ = 1 / (2 * elastic.mu);
}

}  // namespace talus::material
