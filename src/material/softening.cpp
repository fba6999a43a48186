// SPDX-License-Identifier: MIT
#include "material/softening.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::material {
namespace {

/// Returns the strength after all softening, at constant volume unless flow is associated. The tensile strength falls
/// with the cohesion.
MohrCoulombStrength find_residual(const SofteningMohrCoulomb::Input& in) {
  const MohrCoulombStrength& peak = in.get<MohrCoulombStrength>();
  const ResidualStrength& s = in.get<ResidualStrength>();
  const double share = peak.cohesion > 0 ? s.residual_cohesion / peak.cohesion : 0;
  const double dilatancy = in.get<SofteningRange>().is_associated ? s.residual_friction_angle : 0;
  return {s.residual_cohesion, s.residual_friction_angle, dilatancy, share * peak.tensile_strength};
}

}  // namespace

void SofteningRange::check(const SoilFindings& findings) const {
  if (findings.is_sound("softening_start") && findings.is_sound("softening_end") &&
      findings.is_given("softening_end") && softening_end <= softening_start)
    findings.add("softening_end", fmt::format("'softening_end' is {:g}; it must be above 'softening_start', {:g}",
                                              softening_end, softening_start));
}

void SofteningRange::add_properties(Properties& list) const {
  list.push_back({"softening_start", "plastic shear strain at the peak", "ε_p", ShownAs::number, softening_start, {}});
  if (softening_end > 0)
    list.push_back(
        {"softening_end", "plastic shear strain at residual strength", "ε_r", ShownAs::number, softening_end, {}});
}

SofteningMohrCoulomb SofteningMohrCoulomb::make(const Input& in, const StrengthChange& change) {
  StrengthChange rest = change;
  rest.cohesion.reset();  // the cohesion of a stage is that of the peak
  return {LinearElastic::make(in), in.get<MohrCoulombStrength>().changed(change), find_residual(in).changed(rest),
          in.get<SofteningRange>()};
}

void SofteningMohrCoulomb::check(const Input& in, const SoilFindings& findings) {
  const MohrCoulombStrength& peak = in.get<MohrCoulombStrength>();
  const ResidualStrength& s = in.get<ResidualStrength>();
  constexpr double degree = std::numbers::pi / 180;
  peak.check(findings);
  if (findings.is_sound("cohesion") && findings.is_sound("residual_cohesion") && s.residual_cohesion > peak.cohesion)
    findings.add("residual_cohesion", fmt::format("'residual_cohesion' is {}; it must not be above the cohesion, {}",
                                                  format_value(s.residual_cohesion, findings.units.stress),
                                                  format_value(peak.cohesion, findings.units.stress)));
  if (findings.is_sound("friction_angle") && findings.is_sound("residual_friction_angle") &&
      s.residual_friction_angle > peak.friction_angle)
    findings.add("residual_friction_angle",
                 fmt::format("'residual_friction_angle' is {:.6g} deg; it must not be above the friction angle, {:.6g} "
                             "deg",
                             s.residual_friction_angle / degree, peak.friction_angle / degree));
  in.get<SofteningRange>().check(findings);
}

Properties SofteningMohrCoulomb::list_properties(const Input& in) {
  const ResidualStrength& s = in.get<ResidualStrength>();
  Properties list = in.get<MohrCoulombStrength>().list_properties();
  list.push_back(make_divided("residual_cohesion", "residual cohesion", "c_r", ShownAs::stress, s.residual_cohesion));
  list.push_back({"residual_friction_angle", "residual friction angle", "φ_r", ShownAs::angle,
                  s.residual_friction_angle,
                  [angle = s.residual_friction_angle](double factor) { return std::atan(std::tan(angle) / factor); }});
  in.get<SofteningRange>().add_properties(list);
  return list;
}

void SofteningMohrCoulomb::stop_softening(const Input::Changeable& in) {
  const Input given(in);
  if (in.get<SofteningRange>().limit_strength == LimitStrength::residual)
    in.get<MohrCoulombStrength>() = find_residual(given);
}

SliceStrength SofteningMohrCoulomb::find_slice_strength(const Input& in) {
  const MohrCoulombStrength s = in.get<SofteningRange>().limit_strength == LimitStrength::residual
                                    ? find_residual(in)
                                    : in.get<MohrCoulombStrength>();
  return {s.cohesion, s.friction_angle, 0, 0, nullptr};
}

void SofteningMohrCoulomb::divide(const Input::Changeable& in, PartialDivision& division) {
  in.get<MohrCoulombStrength>().divide(division);
  ResidualStrength& s = in.get<ResidualStrength>();
  const bool undrained = s.residual_friction_angle == 0;
  division.divide(s.residual_cohesion, undrained ? division.undrained : division.cohesion, "residual cohesion", "c_r",
                  "kPa", 1e3);
  division.divide_angle(s.residual_friction_angle, division.friction, "residual friction angle", "φ_r");
}

MohrCoulombStrength SofteningMohrCoulomb::find_strength(double strain) const {
  const MohrCoulombStrength &peak = peak_.strength(), &residual = residual_.strength();
  const double share = range_.find_share(strain);
  const auto mix = [share](double a, double b) { return a + share * (b - a); };
  return {mix(peak.cohesion, residual.cohesion),
          std::atan(mix(std::tan(peak.friction_angle), std::tan(residual.friction_angle))),
          std::atan(mix(std::tan(peak.dilatancy_angle), std::tan(residual.dilatancy_angle))),
          mix(peak.tensile_strength, residual.tensile_strength)};
}

}  // namespace talus::material
