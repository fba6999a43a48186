// SPDX-License-Identifier: MIT
#include "material/curved_envelopes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::material {
namespace {

constexpr double kilo = 1e3;
/// Normal stress below which the slope of a joint is that at this stress [Pa].
constexpr double least_stress = 100;

}  // namespace

Properties PowerCurve::list_properties(const Input& in) {
  const PowerCurveInput& s = in.get<PowerCurveInput>();
  return {make_divided("power_factor", "factor of the power curve, for stresses in kPa", "a", ShownAs::number,
                       s.power_factor),
          {"power_exponent", "exponent of the power curve", "b", ShownAs::number, s.power_exponent, {}},
          {"power_shift", "stress added to σ'", "d", ShownAs::stress, s.power_shift, {}},
          make_divided("power_cohesion", "cohesion added to the power curve", "c", ShownAs::stress, s.power_cohesion)};
}

PowerEnvelope PowerCurve::make_envelope(const Input& in) {
  const PowerCurveInput& s = in.get<PowerCurveInput>();
  return {s.power_factor, s.power_exponent, s.power_shift, s.power_cohesion};
}

void StrengthTable::check(const Input& in, const SoilFindings& findings) {
  const StrengthTableInput& s = in.get<StrengthTableInput>();
  if (!findings.is_sound("normal_stresses") || !findings.is_sound("shear_strengths")) return;
  const std::size_t count = s.normal_stresses.size();
  if (count != s.shear_strengths.size())
    return findings.add("shear_strengths",
                        fmt::format("'shear_strengths' of material '{}' has {} values and 'normal_stresses' has {}; "
                                    "they belong together",
                                    findings.name, s.shear_strengths.size(), count));
  if (count < 2)
    return findings.add("normal_stresses",
                        fmt::format("the strength table of material '{}' needs at least two pairs", findings.name));
  const auto name = [&](double stress) { return format_value(stress, findings.units.stress); };
  const double at_zero = s.shear_strengths[0] - s.normal_stresses[0] * (s.shear_strengths[1] - s.shear_strengths[0]) /
                                                    (s.normal_stresses[1] - s.normal_stresses[0]);
  if (s.normal_stresses[1] > s.normal_stresses[0] && at_zero < 0)
    findings.add("normal_stresses",
                 fmt::format("the first two pairs of material '{}' give a strength of {} at σ' = 0; begin the table "
                             "with a pair at a lower stress",
                             findings.name, name(at_zero)));
  for (std::size_t i = 1; i < count; ++i) {
    if (!(s.normal_stresses[i] > s.normal_stresses[i - 1]))
      return findings.add("normal_stresses",
                          fmt::format("'normal_stresses' of material '{}' must rise: {} follows {}", findings.name,
                                      name(s.normal_stresses[i]), name(s.normal_stresses[i - 1])));
    if (s.shear_strengths[i] < s.shear_strengths[i - 1])
      return findings.add("shear_strengths",
                          fmt::format("'shear_strengths' of material '{}' must not fall: {} follows {}", findings.name,
                                      name(s.shear_strengths[i]), name(s.shear_strengths[i - 1])));
    if (i < 2) continue;
    const auto find_slope = [&](std::size_t k) {
      return (s.shear_strengths[k] - s.shear_strengths[k - 1]) / (s.normal_stresses[k] - s.normal_stresses[k - 1]);
    };
    constexpr double rounding = 1e-9;
    if (find_slope(i) > find_slope(i - 1) + rounding)
      return findings.add("shear_strengths",
                          fmt::format("the envelope of material '{}' becomes steeper at {}; a strength envelope is "
                                      "straight or flattens",
                                      findings.name, name(s.normal_stresses[i - 1])));
  }
}

Properties StrengthTable::list_properties(const Input& in) {
  const StrengthTableInput& s = in.get<StrengthTableInput>();
  Properties list;
  for (std::size_t i = 0; i < s.normal_stresses.size(); ++i)
    list.push_back(make_divided("shear_strengths",
                                fmt::format("shear strength at σ' = {:.6g} kPa", s.normal_stresses[i] / kilo), "τ",
                                ShownAs::stress, s.shear_strengths[i]));
  return list;
}

StrengthPairs StrengthTable::make_envelope(const Input& in) {
  const StrengthTableInput& s = in.get<StrengthTableInput>();
  return {s.normal_stresses, s.shear_strengths};
}

Properties BartonBandis::list_properties(const Input& in) {
  const JointInput& s = in.get<JointInput>();
  return {{"joint_roughness", "joint roughness coefficient", "JRC", ShownAs::number, s.joint_roughness, {}},
          {"joint_strength", "compressive strength of the joint's wall", "JCS", ShownAs::stress, s.joint_strength, {}},
          {"residual_friction", "residual friction angle", "φ_r", ShownAs::angle, s.residual_friction, {}}};
}

StrengthLaw BartonBandis::make_strength(const Input& in) {
  StrengthLaw law;
  law.is_curved = true;
  law.find_tangent = [s = in.get<JointInput>()](const StrengthPlane& plane) {
    constexpr double steepest = 70 * std::numbers::pi / 180, degree = std::numbers::pi / 180;
    const double normal = std::max(least_stress, plane.normal),
                 angle = s.residual_friction + s.joint_roughness * degree * std::log10(s.joint_strength / normal);
    if (angle >= steepest) return StrengthTangent{0, std::tan(steepest)};
    const double tangent = std::tan(std::max(0.0, angle));
    if (angle <= 0 || plane.normal <= least_stress) return StrengthTangent{0, tangent};
    // dτ/dσ' = tan θ + σ' θ' / cos² θ with θ' = -JRC/(σ' ln 10), in degrees.
    const double slope = tangent - s.joint_roughness * degree / std::numbers::ln10 * (1 + tangent * tangent);
    return StrengthTangent{normal * (tangent - slope), slope};
  };
  return law;
}

}  // namespace talus::material
