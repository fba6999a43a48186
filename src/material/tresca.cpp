// SPDX-License-Identifier: MIT
#include "material/tresca.hpp"

#include <fmt/format.h>

namespace talus::material {

void Tresca::check(const Input& in, const SoilFindings& findings) {
  const TrescaInput& s = in.get<TrescaInput>();
  const StrengthProfile& profile = in.get<StrengthProfile>();
  if (!s.profile_strengths.empty()) return profile.check(findings, "profile_strengths", s.profile_strengths);
  if (profile.is_given() && findings.is_sound("profile_strengths"))
    findings.add("",
                 fmt::format("material '{}' has a profile without strengths: give 'profile_strengths'", findings.name));
}

Properties Tresca::list_properties(const Input& in) {
  const TrescaInput& s = in.get<TrescaInput>();
  if (!s.profile_strengths.empty()) {
    const auto [low, high] = std::minmax_element(s.profile_strengths.begin(), s.profile_strengths.end());
    return {make_divided("least_undrained_strength", "least undrained shear strength of the profile", "su",
                         ShownAs::stress, *low),
            make_divided("largest_undrained_strength", "largest undrained shear strength of the profile", "su",
                         ShownAs::stress, *high)};
  }
  Properties list{
      make_divided("undrained_strength", "undrained shear strength", "su", ShownAs::stress, s.undrained_strength)};
  if (s.undrained_gradient > 0)
    list.push_back(make_divided("undrained_gradient", "growth of the undrained strength with depth", "dsu/dz",
                                ShownAs::stress_per_length, s.undrained_gradient));
  return list;
}

SliceStrength Tresca::find_slice_strength(const Input& in) {
  const TrescaInput& s = in.get<TrescaInput>();
  SliceStrength strength{s.undrained_strength, 0, s.undrained_gradient, s.undrained_level, nullptr};
  if (s.profile_strengths.empty()) return strength;
  StrengthLaw law;
  law.find_tangent = [values = s.profile_strengths, profile = in.get<StrengthProfile>()](const StrengthPlane& plane) {
    return StrengthTangent{profile.interpolate(values, plane.at[0], plane.at[1], plane.depth), 0};
  };
  strength.law = std::make_shared<const StrengthLaw>(std::move(law));
  return strength;
}

void Tresca::divide(const Input::Changeable& in, PartialDivision& division) {
  TrescaInput& s = in.get<TrescaInput>();
  division.divide(s.undrained_strength, division.undrained, "undrained shear strength", "s_u", "kPa", 1e3);
  division.divide(s.undrained_gradient, division.undrained, "growth of the undrained strength", "ds_u/dz", "kPa/m",
                  1e3);
  for (double& value : s.profile_strengths)
    division.divide(value, division.undrained, "undrained shear strength", "s_u", "kPa", 1e3);
}

void Tresca::set_initial_state(const Input& in, const StateStart& start, double* state) const {
  const TrescaInput& s = in.get<TrescaInput>();
  if (start.strength_growth) {
    state[1] = *start.strength_growth;
    return;
  }
  state[1] = s.profile_strengths.empty()
                 ? s.find_growth(start.level)
                 : in.get<StrengthProfile>().interpolate(s.profile_strengths, start.x, start.level, start.depth) -
                       s.undrained_strength;
}

}  // namespace talus::material
