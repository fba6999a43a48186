// SPDX-License-Identifier: MIT
#pragma once
// Fields of the finite elements as a file that ParaView opens.

#include <string>

#include "results/elements.hpp"

namespace talus::run {

/// fem.json as VTK's XML format (.vtu) with quadratic triangles or tetrahedra: displacement and shear strain of each
/// flow rule at the nodes, plastic elements.
std::string write_vtu(const results::ElementMesh& file);

}  // namespace talus::run
