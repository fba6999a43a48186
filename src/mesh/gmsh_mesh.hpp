// SPDX-License-Identifier: MIT
#pragma once
// The steps of mesh generation inside Gmsh, from a plan or a mesh file to a mesh. All functions require a GmshSession.

#include <functional>
#include <string>

#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"

namespace talus::mesh {

// Renumbering of a mesh along a space-filling curve, for memory locality, and improvement of flat elements.

/// Sorts the elements by the Morton code of their centroids (equal codes keep their order) and numbers the nodes in the
/// order of first use; the named sides are renumbered accordingly. Unused nodes are removed. The order depends on the
/// mesh only. Call this function before other data are derived from the numbers.
template <int D>
void renumber(Mesh<D>& mesh);

// The smallest altitude limits the time step of the whole calculation, so the flattest elements are improved.

/// Directions in which a node may move within its corner (none), curve, surface or volume.
template <int D>
struct Freedom {
  int count = 0;                                      ///< 0 to D
  std::array<std::array<double, D>, D> directions{};  ///< the first `count` are orthonormal
};

/// Moves nodes of badly shaped elements one after the other in small steps, each of which increases the smallest ratio
/// of altitude to element size around the node. Nothing else changes, and the result does not depend on the number of
/// threads. `get_size` returns the target element size [m] at a point.
template <int D>
void raise_altitudes(Mesh<D>& mesh, const std::vector<Freedom<D>>& freedoms,
                     const std::function<double(const typename Mesh<D>::Point&)>& get_size);

// Initialisation and finalisation of Gmsh, whose state is global in the process.

/// A Gmsh session without output, with one thread, a fixed random seed and no configuration files. Gmsh may crash and
/// does not check for signals, so it is used only in a child process (base/foreign_code.hpp).
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Returns Gmsh's last error message without its full stop; "no reason given" if there is none.
  static std::string get_last_error();
};

/// Returns the target element size at a point: the general one or that of the nearest refinement [m].
double compute_size(const Plan& plan, const std::array<double, 2>& x);

/// Builds the geometry of a checked plan in Gmsh's current model and meshes it.
void mesh_with_gmsh(const Plan& plan);

/// Names for extract_mesh(): `region` returns the region at a place (empty: none) and is called for one element of each
/// geometric entity; `sides` returns the sides at a place, of which there may be several.
struct Naming {
  std::function<int(int entity, const std::array<double, 3>& place)> region;
  std::function<std::vector<std::string>(int entity, const std::array<double, 3>& place)> sides;
};

/// Copies the elements of dimension D and the named sides from Gmsh's current model; finish() must follow. Throws Error
/// (wrong_input) if there are no simplices of dimension D, or elements of another kind.
template <int D>
Mesh<D> extract_mesh(const Naming& naming);

/// Returns the directions in which the nodes of extract_mesh() may move on the geometry of the plan, in the same order.
template <int D>
std::vector<Freedom<D>> extract_freedoms();

/// Validates a mesh file before Gmsh reads it, which does not: its header and, in a text file, that the nodes of all
/// elements exist. Throws Error (wrong_input) with the line.
void check_mesh_file(const std::string& path);

/// Reads a file that passed check_mesh_file(); physical groups become regions and sides.
template <int D>
Mesh<D> read_mesh_file(const std::string& path);

}  // namespace talus::mesh
