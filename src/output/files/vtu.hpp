// SPDX-License-Identifier: MIT
#pragma once
// Meshes with fields in VTK's XML format, .vtu, for ParaView.

#include <string>
#include <vector>

namespace talus::output {

/// VTK's numbers of the kinds of cells.
enum class VtuCell { triangle = 5, tetrahedron = 10, quadratic_triangle = 22, quadratic_tetrahedron = 24 };

/// A field: `components` numbers of each point or cell, one after the other.
struct VtuField {
  std::string name;
  int components = 1;
  std::vector<double> values;
  bool is_integer = false;
};

/// A mesh of cells of one kind with its fields.
struct VtuMesh {
  VtuCell cell = VtuCell::triangle;
  std::vector<double> points;  ///< three coordinates of each [m]
  std::vector<int> nodes;      ///< of the cells, one after the other
  std::size_t per_cell = 3;
  std::vector<VtuField> point_fields, cell_fields;
};

/// Returns the content of the file.
std::string write_vtu(const VtuMesh& mesh);

}  // namespace talus::output
