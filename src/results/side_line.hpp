// SPDX-License-Identifier: MIT
#pragma once
// The sides of a section whose soil moves to both, and the slip line of one.

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

}  // namespace talus::results
