// SPDX-License-Identifier: MIT
#pragma once
// A session of Gmsh, and the extraction of its nodes, elements and named sides. All functions require a GmshSession.

#include <string>
#include <vector>

#include "mesh/gmsh_module.hpp"

namespace talus::mesh {

// Initialisation and finalisation of Gmsh, whose state is global in the process.

/// A Gmsh session without output, with one thread, a fixed random seed and no configuration files.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Returns Gmsh's last error message without its full stop; "no reason given" if there is none.
  static std::string get_last_error();
};

/// Copies the elements of dimension D and the named sides from Gmsh's current model; finish() must follow. Throws Error
/// (wrong_input) if there are no simplices of dimension D, or elements of another kind.
template <int D>
Mesh<D> extract_mesh(const Naming& naming);

/// Returns the directions in which the nodes of extract_mesh() may move on the geometry of the plan, in the same order.
template <int D>
std::vector<Freedom<D>> extract_freedoms();

}  // namespace talus::mesh
