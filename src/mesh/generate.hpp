// SPDX-License-Identifier: MIT
#pragma once
// Mesh generation from a plan by the Gmsh library.

#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"

namespace talus::mesh {

/// Meshes the plan, or reads its external file, and finishes the mesh. The mesh conforms to every polygon, line and box
/// side. Named sides are left, right, bottom and top (box), front (z = 0) and back (z = thickness) in 3D, and every
/// named line. Physical groups of an external file keep their names: groups of dimension D are regions ("empty" is the
/// empty region), groups of dimension D-1 are sides.
///
/// The number of triangles of a plan is that of equilateral ones of edge `size`, within a few per cent. Nodes around
/// flat elements are then moved within their curve, surface or volume, because the smallest altitude limits the time
/// step. An external mesh is not changed. The same plan gives a bitwise identical mesh, and its
/// mirror image the mirrored mesh with the same numbers of nodes and elements.
///
/// Throws Error (wrong_input) with one sentence if a polygon intersects itself or the box, two polygons overlap, a file
/// cannot be read or has no elements of this dimension, or Gmsh fails or crashes; throws Error (interrupted) within a
/// tenth of a second if SIGINT or SIGTERM arrives during meshing. Gmsh runs in a child process, so several threads may
/// mesh at the same time.
template <int D>
Mesh<D> generate(const Plan& plan);

}  // namespace talus::mesh
