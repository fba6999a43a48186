// SPDX-License-Identifier: MIT
#include "material/shansep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus::material {

double compute_shansep_strength(const ShansepInput& in, const StrengthProfile& profile, double vertical,
                                const std::array<double, 2>& at, double depth) {
  double ocr = in.ocr.value_or(1);
  if (!in.profile_ocr.empty()) ocr = profile.interpolate(in.profile_ocr, at[0], at[1], depth);
  // S σ'_v (σ'_p/σ'_v)^m vanishes with σ'_v for m < 1, and needs no division there.
  if (!in.profile_preconsolidation.empty()) {
    const double most = profile.interpolate(in.profile_preconsolidation, at[0], at[1], depth);
    ocr = vertical > 0 ? std::max(1.0, most / vertical) : 1;
  }
  return in.added_strength + in.strength_ratio * std::max(0.0, vertical) * std::pow(ocr, in.strength_exponent);
}

void Shansep::check(const Input& in, const SoilFindings& findings) {
  const ShansepInput& s = in.get<ShansepInput>();
  const StrengthProfile& profile = in.get<StrengthProfile>();
  for (const char* key : {"ocr", "profile_ocr", "profile_preconsolidation"})
    if (!findings.is_sound(key)) return;
  const int given = (s.ocr ? 1 : 0) + (s.profile_ocr.empty() ? 0 : 1) + (s.profile_preconsolidation.empty() ? 0 : 1);
  if (given != 1)
    return findings.add(given == 0 ? ""
                        : s.ocr    ? "ocr"
                                   : "profile_ocr",
                        fmt::format("material '{}' needs {}of 'ocr', 'profile_ocr' and 'profile_preconsolidation'",
                                    findings.name, given == 0 ? "one " : "only one "));
  if (!s.profile_ocr.empty()) profile.check(findings, "profile_ocr", s.profile_ocr);
  if (!s.profile_preconsolidation.empty())
    profile.check(findings, "profile_preconsolidation", s.profile_preconsolidation);
}

Properties Shansep::list_properties(const Input& in) {
  const ShansepInput& s = in.get<ShansepInput>();
  Properties list{
      make_divided("strength_ratio", "undrained strength ratio", "S", ShownAs::number, s.strength_ratio),
      {"strength_exponent", "exponent of the overconsolidation ratio", "m", ShownAs::number, s.strength_exponent, {}}};
  if (s.added_strength > 0)
    list.push_back(make_divided("added_strength", "added undrained strength", "A", ShownAs::stress, s.added_strength));
  if (s.ocr) list.push_back({"ocr", "overconsolidation ratio", "OCR", ShownAs::number, *s.ocr, {}});
  return list;
}

SliceStrength Shansep::find_slice_strength(const Input& in) {
  SliceStrength strength;
  StrengthLaw law;
  law.find_tangent = [s = in.get<ShansepInput>(), profile = in.get<StrengthProfile>()](const StrengthPlane& plane) {
    return StrengthTangent{compute_shansep_strength(s, profile, plane.vertical, plane.at, plane.depth), 0};
  };
  strength.law = std::make_shared<const StrengthLaw>(std::move(law));
  return strength;
}

void Shansep::divide(const Input::Changeable& in, PartialDivision& division) {
  ShansepInput& s = in.get<ShansepInput>();
  division.divide(s.strength_ratio, division.undrained, "undrained strength ratio", "S", "", 1);
  division.divide(s.added_strength, division.undrained, "added undrained strength", "A", "kPa", 1e3);
}

void Shansep::set_initial_state(const Input& in, const StateStart& start, double* state) const {
  if (start.strength_growth) {
    state[1] = *start.strength_growth;
    return;
  }
  state[1] = compute_shansep_strength(in.get<ShansepInput>(), in.get<StrengthProfile>(), start.vertical,
                                      {start.x, start.level}, start.depth);
}

}  // namespace talus::material
