// SPDX-License-Identifier: MIT
#pragma once
// Where a section is divided whose soil moves to both sides, as an embankment does on soft ground.

#include <optional>
#include <vector>

namespace talus::mesh {

/// A piece of soil that moved.
struct MovedSoil {
  double x = 0;       ///< where it lay [m]
  double across = 0;  ///< how far it moved towards larger x [m]
  double amount = 0;  ///< its mass or volume
};

/// Soil on the left of `x` moved in the direction `left` (-1, 1) of x, soil on its right in the other.
struct Divide {
  double x = 0;  ///< [m]
  int left = -1;
};

/// The place that best divides soil that moved towards smaller x by more than `threshold` [m] from soil that moved as
/// far towards larger x: that with the least soil on the wrong side of it. Nothing where less than a twentieth of the
/// soil moved one of the two ways, or where the two lie among one another.
std::optional<Divide> find_divide(std::vector<MovedSoil> soil, double threshold);

}  // namespace talus::mesh
