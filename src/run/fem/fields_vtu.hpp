// SPDX-License-Identifier: MIT
#pragma once
// Fields of FEM as a file for ParaView.

#include <string>

#include "results/elements.hpp"

namespace talus::run {

/// Converts fem.json to VTK's XML format (.vtu) with quadratic triangles or tetrahedra: displacement and shear strain
/// of each flow rule at the nodes, and plastic elements.
std::string write_vtu(const results::ElementMesh& file);

}  // namespace talus::run
