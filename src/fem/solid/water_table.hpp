// SPDX-License-Identifier: MIT
#pragma once
// The line of zero pore pressure in a plane field.

#include "mesh/mesh.hpp"

namespace talus::fem {

/// Polylines [m] where the nodal pressure (linear in elements that hold soil) goes from at most zero to above it.
/// Open lines start at their end with the smaller x; closed ones repeat their first point.
std::vector<std::vector<std::array<double, 2>>> find_water_table(const mesh::Mesh<2>& mesh,
                                                                 const std::vector<double>& pressure);

}  // namespace talus::fem
