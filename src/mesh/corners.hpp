// SPDX-License-Identifier: MIT
#pragma once
// Corners of the ground that point into the soil, such as a slope's toe. Stress and strain are singular there, and what
// the elements at such a corner lose is felt by the whole slope.

#include <vector>

#include "mesh/plan.hpp"
#include "mesh/planar.hpp"

namespace talus::mesh {

/// Corners of the plan's polygons inside the box around which there is soil on more than a half circle by at least 10°,
/// but not all around. In 3D each is the trace of a line along the extrusion.
std::vector<Point2> find_reentrant_corners(const Plan& plan);

/// The plan with elements of size / `finer` at its re-entrant corners, which reach the general size `reach` general
/// sizes away. `finer` = 1: the plan as it is.
Plan refine_corners(Plan plan, double finer, double reach);

}  // namespace talus::mesh
