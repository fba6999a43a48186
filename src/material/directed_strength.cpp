// SPDX-License-Identifier: MIT
#include "material/directed_strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace talus::material {
namespace {

constexpr double degree = std::numbers::pi / 180;

double blend(double a, double b, double t) {
  return a + (b - a) * t;
}

}  // namespace

Properties Adp::list_properties(const Input& in) {
  const AdpInput& s = in.get<AdpInput>();
  Properties list = Tresca::list_properties(in);
  list.push_back({"direct_ratio", "direct over active strength", "s_uD/s_uA", ShownAs::number, s.direct_ratio, {}});
  list.push_back({"passive_ratio", "passive over active strength", "s_uP/s_uA", ShownAs::number, s.passive_ratio, {}});
  return list;
}

StrengthLaw Adp::make_strength(const Input& in) {
  StrengthLaw law;
  law.is_directed = true;
  law.find_tangent = [s = in.get<AdpInput>(), profile = in.get<StrengthProfile>(),
                      soil = in.get<TrescaInput>()](const StrengthPlane& plane) {
    const double active = soil.profile_strengths.empty()
                              ? soil.undrained_strength + soil.find_growth(plane.at[1])
                              : profile.interpolate(soil.profile_strengths, plane.at[0], plane.at[1], plane.depth);
    const double share = std::sin(2 * std::clamp(std::abs(plane.dip), 0.0, 45 * degree));
    return StrengthTangent{active * blend(s.direct_ratio, plane.dip >= 0 ? 1.0 : s.passive_ratio, share), 0};
  };
  return law;
}

void Adp::divide(const Input::Changeable& in, PartialDivision& division) {
  Tresca::divide(Tresca::Input::Changeable(in), division);
}

void Anisotropic::check(const Input& in, const SoilFindings& findings) {
  const AnisotropicInput& s = in.get<AnisotropicInput>();
  for (const char* key : {"base_inclinations", "inclined_cohesions", "inclined_frictions"})
    if (!findings.is_sound(key)) return;
  const std::size_t count = s.base_inclinations.size();
  const auto check_size = [&](const char* key, std::size_t size) {
    if (size != count)
      findings.add(key, fmt::format("'{}' of material '{}' has {} values and 'base_inclinations' has {}; they belong "
                                    "together",
                                    key, findings.name, size, count));
  };
  if (count == 0)
    return findings.add("base_inclinations",
                        fmt::format("material '{}' needs at least one inclination", findings.name));
  check_size("inclined_cohesions", s.inclined_cohesions.size());
  check_size("inclined_frictions", s.inclined_frictions.size());
  for (std::size_t i = 1; i < count; ++i)
    if (!(s.base_inclinations[i] > s.base_inclinations[i - 1]))
      return findings.add(
          "base_inclinations",
          fmt::format("'base_inclinations' of material '{}' must rise: {:g}° follows {:g}°", findings.name,
                      s.base_inclinations[i] / degree, s.base_inclinations[i - 1] / degree));
}

StrengthLaw Anisotropic::make_strength(const Input& in) {
  StrengthLaw law;
  law.is_directed = true;
  const auto& table = in.get<AnisotropicInput>();
  // Both numbers of a weak inclination are at most those of its neighbours.
  const auto is_weaker = [&](std::size_t i, std::size_t than) {
    return table.inclined_cohesions[i] <= table.inclined_cohesions[than] &&
           table.inclined_frictions[i] <= table.inclined_frictions[than];
  };
  for (std::size_t i = 0; i < table.base_inclinations.size(); ++i)
    if ((i == 0 || is_weaker(i, i - 1)) && (i + 1 == table.base_inclinations.size() || is_weaker(i, i + 1)))
      law.weak_inclinations.push_back(table.base_inclinations[i]);
  law.find_tangent = [s = in.get<AnisotropicInput>()](const StrengthPlane& plane) {
    const std::vector<double>& x = s.base_inclinations;
    const auto above = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), plane.inclination) - x.begin());
    const std::size_t i = std::min(above, x.size() - 1), before = above > 0 ? above - 1 : 0;
    const double t = i > before ? (plane.inclination - x[before]) / (x[i] - x[before]) : 0;
    return StrengthTangent{blend(s.inclined_cohesions[before], s.inclined_cohesions[i], t),
                           blend(std::tan(s.inclined_frictions[before]), std::tan(s.inclined_frictions[i]), t)};
  };
  return law;
}

void Bedding::check(const Input& in, const SoilFindings& findings) {
  const BeddingInput& s = in.get<BeddingInput>();
  in.get<MohrCoulombStrength>().check(findings);
  if (findings.is_sound("bedding_dilatancy") && findings.is_sound("bedding_friction") &&
      s.bedding_dilatancy > s.bedding_friction)
    findings.add("bedding_dilatancy",
                 fmt::format("'bedding_dilatancy' of material '{}' is {:g}°; it must not be above 'bedding_friction', "
                             "{:g}°",
                             findings.name, s.bedding_dilatancy / degree, s.bedding_friction / degree));
  if (!findings.is_sound("bedding_range") || !findings.is_sound("bedding_transition")) return;
  if (s.bedding_transition && *s.bedding_transition < s.bedding_range)
    findings.add(
        "bedding_transition",
        fmt::format("'bedding_transition' of material '{}' is {:g}°; it must not be below 'bedding_range', {:g}°",
                    findings.name, *s.bedding_transition / degree, s.bedding_range / degree));
}

Properties Bedding::list_properties(const Input& in) {
  const MohrCoulombStrength& soil = in.get<MohrCoulombStrength>();
  const BeddingInput& s = in.get<BeddingInput>();
  const auto divide_angle = [](double angle) {
    return [angle](double factor) { return std::atan(std::tan(angle) / factor); };
  };
  return {make_divided("cohesion", "cohesion", "c", ShownAs::stress, soil.cohesion),
          {"friction_angle", "angle of internal friction", "φ", ShownAs::angle, soil.friction_angle,
           divide_angle(soil.friction_angle)},
          {"bedding_angle", "inclination of the bedding", "α_b", ShownAs::angle, s.bedding_angle, {}},
          make_divided("bedding_cohesion", "cohesion of the bedding", "c_b", ShownAs::stress, s.bedding_cohesion),
          {"bedding_friction", "friction angle of the bedding", "φ_b", ShownAs::angle, s.bedding_friction,
           divide_angle(s.bedding_friction)}};
}

StrengthLaw Bedding::make_strength(const Input& in) {
  StrengthLaw law;
  law.is_directed = true;
  law.weak_inclinations = {in.get<BeddingInput>().bedding_angle};
  law.find_tangent = [soil = in.get<MohrCoulombStrength>(), s = in.get<BeddingInput>()](const StrengthPlane& plane) {
    // Planes have no sense, so that 89° and -89° are 2° apart.
    const double turned = std::remainder(plane.inclination - s.bedding_angle, std::numbers::pi),
                 away = std::abs(turned), end = s.bedding_transition.value_or(s.bedding_range);
    // A base laid along the bedding differs from it by rounding.
    constexpr double rounding = 1e-9;
    const double t = away <= s.bedding_range + rounding ? 0
                     : away >= end                      ? 1
                                                        : (away - s.bedding_range) / (end - s.bedding_range);
    return StrengthTangent{blend(s.bedding_cohesion, soil.cohesion, t),
                           blend(std::tan(s.bedding_friction), std::tan(soil.friction_angle), t)};
  };
  return law;
}

SliceStrength Bedding::find_slice_strength(const Input& in) {
  const auto& soil = in.get<MohrCoulombStrength>();
  const auto& s = in.get<BeddingInput>();
  SliceStrength strength;
  strength.cohesion = soil.cohesion, strength.friction_angle = soil.friction_angle;
  strength.planes = PlanesStrength{s.bedding_angle, s.bedding_cohesion, s.bedding_friction};
  strength.law = std::make_shared<const StrengthLaw>(make_strength(in));
  return strength;
}

Bedding Bedding::make(const Input& in, const StrengthChange& change) {
  const BeddingInput& s = in.get<BeddingInput>();
  StrengthChange rest = change;
  rest.cohesion.reset();  // the cohesion of a stage is that of the soil
  // The tensile strength of the rock limits tension on planes of all directions.
  const MohrCoulombStrength planes{s.bedding_cohesion, s.bedding_friction, s.bedding_dilatancy, 0};
  return {
      {LinearElastic::make(in), in.get<MohrCoulombStrength>().changed(change)}, planes.changed(rest), s.bedding_angle};
}

Bedding::Bedding(const MohrCoulomb& soil, const MohrCoulombStrength& planes, double angle)
    : PointLaw(soil.elastic()), soil_(soil), planes_(planes), along_{std::cos(angle), std::sin(angle)} {}

}  // namespace talus::material
