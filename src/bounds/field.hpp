// SPDX-License-Identifier: MIT
#pragma once
// The fields of both bounds.

#include "bounds/problem.hpp"
#include "bounds/velocities.hpp"

namespace talus::bounds {

/// Effective stress at the corners of the triangles.
struct StressField {
  std::vector<std::array<Stress, 3>> stress;  ///< [Pa]
};

/// Velocities at the nodes of the six-node triangles, of any size.
struct VelocityField {
  Velocities mesh;
  std::vector<Vec<2>> velocity;
};

}  // namespace talus::bounds
