// SPDX-License-Identifier: MIT
#include "material/drucker_prager.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace talus::material {

DruckerPragerCone DruckerPragerCone::match(ConeMatch cone, double friction_angle, double dilatancy_angle) {
  const double sine = std::sin(friction_angle), cosine = std::cos(friction_angle), sine_psi = std::sin(dilatancy_angle);
  const auto find_inscribed = [](double s) { return 3 * s / std::sqrt(9 + 3 * s * s); };
  switch (cone) {
    case ConeMatch::compression:
    case ConeMatch::extension: {
      const double sign = cone == ConeMatch::compression ? -1 : 1;
      const auto find = [&](double numerator, double s) { return 6 * numerator / (std::sqrt(3.0) * (3 + sign * s)); };
      return {find(sine, sine), find(cosine, sine), find(sine_psi, sine_psi)};
    }
    case ConeMatch::inscribed:
      return {find_inscribed(sine), 3 * cosine / std::sqrt(9 + 3 * sine * sine), find_inscribed(sine_psi)};
    case ConeMatch::plane_strain:
      break;
  }
  // Without plastic strain across the plane s_z = -(2/3) η_ψ √J2, so that R = √J2 √(1 - η_ψ²/3) and p = σ_m - η_ψ
  // √J2/3.
  const double dilation = find_inscribed(sine_psi), radius = std::sqrt(1 - dilation * dilation / 3);
  const double share = 1 / (radius + dilation * sine / 3);
  return {share * sine, share * cosine, dilation};
}

StrengthTangent DruckerPragerCone::find_plane_strength(double cohesion) const {
  const double share = std::sqrt(1 - dilation * dilation / 3) / (1 - slope * dilation / 3), sine = share * slope;
  if (!(sine < 1)) return {std::nan(""), std::nan("")};
  const double cosine = std::sqrt(1 - sine * sine);
  return {share * offset * cohesion / cosine, sine / cosine};
}

void DruckerPrager::check(const Input& in, const SoilFindings& findings) {
  // The apex of every match is that of the pyramid.
  const MohrCoulombStrength& s = in.get<MohrCoulombStrength>();
  s.check(findings);
  if (!findings.is_sound("friction_angle") || !findings.is_sound("dilatancy_angle") || !findings.is_sound("cone"))
    return;
  const auto cone = DruckerPragerCone::match(in.get<DruckerPragerInput>().cone, s.friction_angle, s.dilatancy_angle);
  if (std::isnan(cone.find_plane_strength(s.cohesion).tan_friction))
    findings.add("cone", fmt::format("the cone of material '{}' cannot fail in plane strain: with a friction angle of "
                                     "{:.4g} deg it is too wide; use \"plane_strain\" or \"inscribed\"",
                                     findings.name, s.friction_angle * 180 / std::numbers::pi));
}

Properties DruckerPrager::list_properties(const Input& in) {
  const MohrCoulombStrength& given = in.get<MohrCoulombStrength>();
  const ConeMatch cone = in.get<DruckerPragerInput>().cone;
  Properties list = given.list_properties();
  const auto find_slope = [given, cone](double factor) {
    const MohrCoulombStrength s = given.reduced(factor);
    return DruckerPragerCone::match(cone, s.friction_angle, s.dilatancy_angle).slope;
  };
  list.push_back({"cone_slope", "slope of the cone", "η", ShownAs::number, find_slope(1), find_slope});
  return list;
}

SliceStrength DruckerPrager::find_slice_strength(const Input& in) {
  const MohrCoulombStrength& s = in.get<MohrCoulombStrength>();
  const StrengthTangent t =
      DruckerPragerCone::match(in.get<DruckerPragerInput>().cone, s.friction_angle, s.dilatancy_angle)
          .find_plane_strength(s.cohesion);
  return {t.cohesion, std::atan(t.tan_friction), 0, 0, nullptr};
}

DruckerPrager::DruckerPrager(const LinearElastic& elastic, const MohrCoulombStrength& strength, ConeMatch match)
    : elastic_(elastic) {
  const auto cone = DruckerPragerCone::match(match, strength.friction_angle, strength.dilatancy_angle);
  slope_ = cone.slope;
  dilation_ = cone.dilation;
  strength_ = cone.offset * strength.cohesion;
  tolerance_ = 1e-12 * elastic.mu;
  smallest_ = 1e-3 * tolerance_;
  const double apex = slope_ > 0 ? strength_ / slope_ : std::numeric_limits<double>::max();
  tension_ = std::min(strength.tensile_strength, apex);
  bulk_ = elastic.lambda + 2.0 / 3 * elastic.mu;
  over_stiffness_ = 1 / (elastic.mu + bulk_ * slope_ * dilation_);
}

}  // namespace talus::material
