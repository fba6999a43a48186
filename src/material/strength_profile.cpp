// SPDX-License-Identifier: MIT
#include "material/strength_profile.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace talus::material {

double StrengthProfile::interpolate(const std::vector<double>& values, double x, double level, double depth) const {
  const bool by_level = !profile_levels.empty();
  const std::vector<double>& given = by_level ? profile_levels : profile_depths;
  const auto find_depth = [&](std::size_t i) { return by_level ? -given[i] : given[i]; };
  const double at = by_level ? -level : depth;
  const auto interpolate_profile = [&](std::size_t profile) {
    const double* value = values.data() + profile * given.size();
    if (at <= find_depth(0)) return value[0];
    for (std::size_t i = 1; i < given.size(); ++i)
      if (at < find_depth(i))
        return value[i - 1] +
               (value[i] - value[i - 1]) * (at - find_depth(i - 1)) / (find_depth(i) - find_depth(i - 1));
    return value[given.size() - 1];
  };
  if (profile_x.empty() || x <= profile_x.front()) return interpolate_profile(0);
  for (std::size_t i = 1; i < profile_x.size(); ++i)
    if (x < profile_x[i]) {
      const double share = (x - profile_x[i - 1]) / (profile_x[i] - profile_x[i - 1]);
      return (1 - share) * interpolate_profile(i - 1) + share * interpolate_profile(i);
    }
  return interpolate_profile(profile_x.size() - 1);
}

void StrengthProfile::check(const SoilFindings& findings, const char* key, const std::vector<double>& values) const {
  for (const char* part : {"profile_levels", "profile_depths", "profile_x", key})
    if (!findings.is_sound(part)) return;
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
  if (const std::size_t profiles = std::max<std::size_t>(1, profile_x.size()); profiles * given.size() != values.size())
    return findings.add(
        key, fmt::format("'{}' of material '{}' has {} values and '{}' has {}{}; they belong together", key,
                         findings.name, values.size(), places, given.size(),
                         profile_x.empty() ? "" : fmt::format(" at each of {} places in 'profile_x'", profiles)));
  for (std::size_t i = 1; i < profile_x.size(); ++i)
    if (profile_x[i] <= profile_x[i - 1])
      return findings.add("profile_x",
                          fmt::format("'profile_x' of material '{}' must rise from one to the next: {:g} m "
                                      "follows {:g} m",
                                      findings.name, profile_x[i], profile_x[i - 1]));
  for (std::size_t i = 1; i < given.size(); ++i)
    if (by_level ? given[i] >= given[i - 1] : given[i] <= given[i - 1])
      return findings.add(places,
                          fmt::format("'{}' of material '{}' must {} from one to the next: {:g} m follows "
                                      "{:g} m",
                                      places, findings.name, by_level ? "fall" : "rise", given[i], given[i - 1]));
}

}  // namespace talus::material
