// SPDX-License-Identifier: MIT
#pragma once
// The steps between a plan and a mesh that happen inside Gmsh. All need a GmshSession.

#include <functional>
#include <string>

#include "mesh/finish.hpp"
#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"

namespace talus::mesh {

// The start and the end of Gmsh, which keeps one global state per process.

/// Gmsh for the caller: quiet, one thread, a fixed random seed, no configuration files, nothing left behind. Gmsh may
/// crash and does not look for interruptions, so the program has one only in a child process (base/foreign_code.hpp).
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Gmsh's last message of an error, without its full stop; "no reason given" where there is none.
  static std::string get_last_error();
};

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
