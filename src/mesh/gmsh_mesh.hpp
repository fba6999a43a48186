// SPDX-License-Identifier: MIT
#pragma once
// The steps between a plan and a mesh that happen inside Gmsh. All need a GmshSession.

#include <functional>

#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"
#include "mesh/raise_altitudes.hpp"

namespace talus::mesh {

/// Wanted element size at a place: the general one, or what the nearest refinement asks for [m].
double compute_size(const Plan& plan, const std::array<double, 2>& x);

/// Builds the geometry of a checked plan in Gmsh's current model and meshes it.
void mesh_with_gmsh(const Plan& plan);

/// Name of the region at a place, or of nothing (empty string); used on one element of each geometric entity.
/// Names of the sides at a place; a place may lie on several.
struct Naming {
  std::function<int(int entity, const std::array<double, 3>& place)> region;
  std::function<std::vector<std::string>(int entity, const std::array<double, 3>& place)> sides;
};

/// Copies the elements of dimension D and the named sides out of Gmsh's current model; nothing is finished yet.
/// Throws Error (wrong_input) when there are no simplices of dimension D, or elements of another kind.
template <int D>
Mesh<D> extract_mesh(const Naming& naming);

/// How the nodes of extract_mesh() may move on the geometry of the plan, in the same order.
template <int D>
std::vector<Freedom<D>> extract_freedoms();

/// Looks at a ready mesh file before Gmsh does, which believes what it reads: its header and, in a text file, that
/// every element's nodes exist. Throws Error (wrong_input) with the line.
void check_mesh_file(const std::string& path);

/// Opens a file that check_mesh_file() took and copies it; physical groups give regions and sides.
template <int D>
Mesh<D> read_mesh_file(const std::string& path);

}  // namespace talus::mesh
