// SPDX-License-Identifier: MIT
#pragma once
// Checks a plan before the mesh generator sees it, whose own messages would tell a user little.

#include "mesh/plan.hpp"

namespace talus::mesh {

/// Lengths below this are taken as zero: a millionth of the element size [m].
double get_tolerance(const Plan& plan);

/// The plan with points that nearly coincide (within the tolerance) made the same: on the sides and corners of the box
/// and on one another. Throws Error (wrong_input) with one sentence when a size is not positive, a name is missing,
/// used twice or reserved, a polygon crosses itself or leaves the box, two polygons overlap partly, or a line leaves
/// the box.
Plan check_plan(const Plan& plan);

}  // namespace talus::mesh
