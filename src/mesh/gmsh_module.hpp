// SPDX-License-Identifier: MIT
#pragma once
// Interface of the module libtalus_gmsh.so, which contains all that calls Gmsh. The program loads it when it needs a
// mesh: Gmsh brings nearly 80 libraries, which would take most of the time of a program that starts and ends.
//
// Gmsh may crash and does not check for signals, so these functions are called in a child process only
// (base/foreign_code.hpp).

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"

namespace talus::mesh {

/// Directions in which a node may move within its corner (none), curve, surface or volume.
template <int D>
struct Freedom {
  int count = 0;                                      ///< 0 to D
  std::array<std::array<double, D>, D> directions{};  ///< the first `count` are orthonormal
};

/// Names of what is meshed: `region` returns the region at a place (empty: none) and is called for one element of each
/// geometric entity; `sides` returns the sides at a place, of which there may be several.
struct Naming {
  std::function<int(int entity, const std::array<double, 3>& place)> region;
  std::function<std::vector<std::string>(int entity, const std::array<double, 3>& place)> sides;
};

/// Hash of the sizes of exchanged structures; differs between builds that are incompatible.
inline constexpr std::size_t gmsh_layout = sizeof(Plan) + 31 * (sizeof(Naming) + 31 * sizeof(Mesh<3>));

}  // namespace talus::mesh

/// Returns gmsh_layout of the module.
extern "C" std::size_t talus_gmsh_layout();

/// Meshes a checked plan whose polygons and lines are in canonical order, and writes for each node in which directions
/// it may move on the geometry of the plan; finish() must follow. Throws Error (wrong_input) if Gmsh fails.
extern "C" void talus_mesh_plan_2(const talus::mesh::Plan& plan, const talus::mesh::Naming& naming,
                                  talus::mesh::Mesh<2>& mesh, std::vector<talus::mesh::Freedom<2>>& freedoms);
extern "C" void talus_mesh_plan_3(const talus::mesh::Plan& plan, const talus::mesh::Naming& naming,
                                  talus::mesh::Mesh<3>& mesh, std::vector<talus::mesh::Freedom<3>>& freedoms);

/// Reads a file that passed check_mesh_file(); physical groups become regions and sides. Throws Error (wrong_input) if
/// there are no simplices of this dimension, or elements of another kind.
extern "C" void talus_read_mesh_2(const std::string& path, talus::mesh::Mesh<2>& mesh);
extern "C" void talus_read_mesh_3(const std::string& path, talus::mesh::Mesh<3>& mesh);
