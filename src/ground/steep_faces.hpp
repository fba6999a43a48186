// SPDX-License-Identifier: MIT
#pragma once
// Faces of soil without cohesion that are steeper than its friction angle: unstable by inspection.

#include <string>
#include <vector>

#include "ground/ground_line.hpp"
#include "input/case/case.hpp"

namespace talus::ground {

struct SteepFace {
  Point lower{}, upper{};  ///< [m]
  std::string material;
  double slope = 0;           ///< β [rad]
  double friction_angle = 0;  ///< φ [rad]
  /// tan φ / tan β, the factor of a long slope of dry soil.
  double factor() const;
};

/// From left to right; of a plane section without overhangs. Soil with suction or roots is left out: they hold it.
std::vector<SteepFace> find_steep_faces(const input::Case& data);

/// "The ground between (…) and (…) rises at 51.8°, …".
std::string describe(const SteepFace& face);

}  // namespace talus::ground
