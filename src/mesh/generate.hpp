// SPDX-License-Identifier: MIT
#pragma once
// From a plan to a finished mesh, through the Gmsh library.

#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"

namespace talus::mesh {

/// Meshes the plan (or reads its ready file) and finishes the mesh. Every polygon, line and box side is conformed to.
/// Named sides: left, right, bottom, top (box), front (z = 0) and back (z = thickness) in 3D, and every named line.
/// Physical groups of a ready file keep their names: groups of dimension D are regions ("empty" is the empty region),
/// groups of dimension D-1 are sides.
/// A plan's triangles are as many as equilateral ones of edge `size` (within a few percent); nodes around flat elements
/// are then moved within their curve, surface or volume, because the smallest altitude sets the time step. A ready file
/// is taken as it is. The same plan gives the same mesh, bit for bit.
/// Throws Error (wrong_input) with one sentence when a polygon crosses itself or the box, two polygons overlap, a file
/// cannot be read or holds no elements of this dimension, or Gmsh fails or crashes; Error (interrupted) within a tenth
/// of a second when SIGINT or SIGTERM arrives while Gmsh works. Gmsh works in a child process, so several threads may
/// mesh at once.
template <int D>
Mesh<D> generate(const Plan& plan);

}  // namespace talus::mesh
