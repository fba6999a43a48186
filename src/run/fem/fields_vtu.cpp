// SPDX-License-Identifier: MIT
#include "run/fem/fields_vtu.hpp"

#include <fmt/format.h>

namespace talus::run {
namespace {

/// VTK cell types of quadratic elements.
constexpr int quadratic_triangle = 22, quadratic_tetrahedron = 24;

std::string write_array(const std::string& name, const char* type, int components, const std::string& values) {
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">{}</DataArray>\n",
                     type, name, components, values);
}

/// Formats vectors with three components in any dimension.
std::string list_vectors(const std::vector<std::vector<double>>& rows) {
  std::string text;
  for (const std::vector<double>& row : rows)
    for (std::size_t d = 0; d < 3; ++d) text += fmt::format(" {}", d < row.size() ? row[d] : 0.0);
  return text;
}

template <class T>
std::string list_numbers(const std::vector<T>& values) {
  std::string text;
  for (const T v : values) text += fmt::format(" {}", static_cast<double>(v));
  return text;
}

}  // namespace

std::string write_vtu(const results::ElementMesh& file) {
  const auto& nodes = file.nodes;
  const auto& elements = file.elements;
  const std::size_t per = elements.empty() ? 6 : elements[0].size();
  std::string connectivity, offsets, types, point_data, cell_data;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    connectivity += list_numbers(elements[e]);
    offsets += fmt::format(" {}", per * (e + 1));
    types += fmt::format(" {}", per == 6 ? quadratic_triangle : quadratic_tetrahedron);
  }
  for (const results::ElementFields& run : file.runs) {
    const std::string flow = results::to_word(run.flow);
    point_data += write_array("displacement_" + flow, "Float64", 3, list_vectors(run.displacement));
    point_data += write_array("shear_strain_" + flow, "Float64", 1, list_numbers(run.shear_strain));
    cell_data += write_array("yields_" + flow, "Int32", 1, list_numbers(run.yields));
  }
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n<UnstructuredGrid>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n{}</Points>\n<Cells>\n{}{}{}</Cells>\n"
      "<PointData>\n{}</PointData>\n<CellData>\n{}</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
      nodes.size(), elements.size(), write_array("points", "Float64", 3, list_vectors(nodes)),
      write_array("connectivity", "Int32", 1, connectivity), write_array("offsets", "Int32", 1, offsets),
      write_array("types", "UInt8", 1, types), point_data, cell_data);
}

}  // namespace talus::run
