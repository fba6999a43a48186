// SPDX-License-Identifier: MIT
#pragma once
// A quantity of a soil along one or several vertical profiles, by elevation or by depth under the ground.

#include <vector>

#include "material/linear_elastic.hpp"

namespace talus::material {

/// Places of a profile, of which a soil gives elevations or depths.
struct StrengthProfile {
  std::vector<double> profile_levels;  ///< elevations, from the top down [m]
  std::vector<double> profile_depths;  ///< under the ground, increasing [m]
  std::vector<double> profile_x;       ///< horizontal places of several profiles, increasing; empty: one profile [m]

  bool is_given() const { return !profile_levels.empty() || !profile_depths.empty(); }
  /// Returns the value at a place, elevation and depth [m], linear between the places and constant beyond them. Values
  /// are given profile by profile.
  double interpolate(const std::vector<double>& values, double x, double level, double depth) const;
  /// Reports a profile without places, with two kinds of places, in the wrong order, or of another length than the
  /// `values` of `key`.
  void check(const SoilFindings& findings, const char* key, const std::vector<double>& values) const;
};
inline void describe(input::Visitor& v, StrengthProfile& in, const Users& users) {
  v.key("profile_levels", in.profile_levels, users.allow(quantity("m")).example("[10, 6, 0]"),
        "Elevations y of a profile, from the top down; its values are linear between them and constant beyond.");
  v.key("profile_depths", in.profile_depths, users.allow(quantity("m").at_least(0)).example("[0, 4, 10]"),
        "Depths under the ground instead, from the top down.");
  v.key("profile_x", in.profile_x, users.allow(quantity("m")).example("[0, 40]"),
        "Horizontal places of several profiles, as of soundings, from left to right. Their values follow profile by "
        "profile, at the same levels or depths, and are linear between the profiles and constant beyond them.");
}

}  // namespace talus::material
