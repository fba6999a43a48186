// SPDX-License-Identifier: MIT
#pragma once
// Steps of mesh generation before and after Gmsh.

#include <functional>
#include <string>

#include "mesh/gmsh_module.hpp"
#include "mesh/mesh.hpp"

namespace talus::mesh {

// Renumbering of a mesh along a space-filling curve, for memory locality, and improvement of flat elements.

/// Sorts the elements by the Morton code of their centroids (equal codes keep their order) and numbers the nodes in the
/// order of first use; the named sides are renumbered accordingly. Unused nodes are removed. The order depends on the
/// mesh only. Call this function before other data are derived from the numbers.
template <int D>
void renumber(Mesh<D>& mesh);

// The smallest altitude limits the time step of the whole calculation, so the flattest elements are improved.

/// Moves nodes of badly shaped elements one after the other in small steps, each of which increases the smallest ratio
/// of altitude to element size around the node. Nothing else changes, and the result does not depend on the number of
/// threads. `get_size` returns the target element size [m] at a point.
template <int D>
void raise_altitudes(Mesh<D>& mesh, const std::vector<Freedom<D>>& freedoms,
                     const std::function<double(const typename Mesh<D>::Point&)>& get_size);

/// Validates a mesh file before Gmsh reads it, which does not: its header and, in a text file, that the nodes of all
/// elements exist. Throws Error (wrong_input) with the line.
void check_mesh_file(const std::string& path);

}  // namespace talus::mesh
