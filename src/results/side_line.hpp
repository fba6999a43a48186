// SPDX-License-Identifier: MIT
#pragma once
// The sides of a section whose soil moves to both, and the slip line of one.

#include <optional>
#include <string>
#include <vector>

#include "results/about.hpp"

namespace talus::results {

/// "to the left", "to the right" of a section whose x grows to the right.
inline const char* name_side(int direction) {
  return direction < 0 ? "to the left" : "to the right";
}

struct SideLine {
  int direction = 1;          ///< +1: the soil moves towards larger x
  std::vector<Point> points;  ///< [m]
};
template <class V, As<SideLine> R>
void describe(V& v, R& r) {
  v.key("direction", r.direction, {"", "1: towards larger x, -1: towards smaller x"});
  v.key("points", r.points, {"m", "its points"});
}

/// The direction of an earthquake that governs where both were tried.
struct EarthquakeSide {
  int direction = 0;                   ///< -1 towards smaller x, 1 towards larger x
  std::optional<double> other_stable;  ///< a factor at which the slope is stable in the other direction
};
template <class V, As<EarthquakeSide> R>
void describe(V& v, R& r) {
  v.key("direction", r.direction,
        {"", "direction of the earthquake that governs: -1 towards smaller x, 1 towards larger x"});
  v.key(
      "other_stable", r.other_stable,
      {"", "factor at which the slope is stable in the other direction: with equilibrium on the same mesh, or proven"});
}

/// "the earthquake towards smaller x governs (towards larger x WHAT 1.620)".
std::string describe_side(const EarthquakeSide& side, const char* what);
inline constexpr const char *stable_on_mesh = "the same mesh is in equilibrium at",
                            *proven_stable = "the lower bound is";

}  // namespace talus::results
