// SPDX-License-Identifier: MIT
#include "material/strength_profile.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace talus::material {

double StrengthProfile::interpolate(const std::vector<double>& values, double level, double depth) const {
  const bool by_level = !profile_levels.empty();
  const std::vector<double>& given = by_level ? profile_levels : profile_depths;
  const auto find_depth = [&](std::size_t i) { return by_level ? -given[i] : given[i]; };
  const double at = by_level ? -level : depth;
  if (at <= find_depth(0)) return values.front();
  for (std::size_t i = 1; i < values.size(); ++i)
    if (at < find_depth(i))
      return values[i - 1] +
             (values[i] - values[i - 1]) * (at - find_depth(i - 1)) / (find_depth(i) - find_depth(i - 1));
  return values.back();
}

void StrengthProfile::check(const SoilFindings& findings, const char* key, const std::vector<double>& values) const {
  if (!findings.is_sound("profile_levels") || !findings.is_sound("profile_depths") || !findings.is_sound(key)) return;
  if (!profile_levels.empty() && !profile_depths.empty())
    return findings.add("profile_depths", fmt::format("material '{}' has 'profile_levels' and 'profile_depths'; give "
                                                      "one of them",
                                                      findings.name));
  const bool by_level = !profile_levels.empty();
  const std::vector<double>& given = by_level ? profile_levels : profile_depths;
  const char* places = by_level ? "profile_levels" : "profile_depths";
  if (given.empty())
    return findings.add(key, fmt::format("'{}' of material '{}' needs its places: 'profile_levels' or 'profile_depths'",
                                         key, findings.name));
  if (given.size() != values.size())
    return findings.add(key, fmt::format("'{}' of material '{}' has {} values and '{}' has {}; they belong together",
                                         key, findings.name, values.size(), places, given.size()));
  for (std::size_t i = 1; i < given.size(); ++i)
    if (by_level ? given[i] >= given[i - 1] : given[i] <= given[i - 1])
      return findings.add(places,
                          fmt::format("'{}' of material '{}' must {} from one to the next: {:g} m follows "
                                      "{:g} m",
                                      places, findings.name, by_level ? "fall" : "rise", given[i], given[i - 1]));
}

}  // namespace talus::material
