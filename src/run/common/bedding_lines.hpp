// SPDX-License-Identifier: MIT
#pragma once
// Lines of the mesh along bedding. The velocities of FEM, limit analysis and MPM are continuous: soil slips on its
// bedding without straining otherwise only between two lines of the mesh in that direction.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"

namespace talus::run {

/// Returns true if a soil of the regions has bedding.
bool has_bedding(const input::Case& data);

/// Returns true if LEM gives the strength of the bedding of a soil to planes of other directions too, as limit analysis
/// does not.
bool has_wide_bedding(const input::Material& soil);

/// Returns the mesh of the plan with lines along the bedding of each polygon, through its corners and at most `spacing`
/// element sizes apart. Where the mesh generator does not cope, as with lines that nearly touch, and in a mesh from a
/// file there are none, and a sentence is added to `notes`.
mesh::Mesh<2> generate_with_bedding(const input::Case& data, const mesh::Plan& plan, double spacing,
                                    std::vector<std::string>& notes);

/// The same with lines one element size apart; in 3D there are none.
template <int D>
mesh::Mesh<D> generate_along_bedding(const input::Case& data, const mesh::Plan& plan, std::vector<std::string>& notes);

}  // namespace talus::run
