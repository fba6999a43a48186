// SPDX-License-Identifier: MIT
#include "output/files/vtu.hpp"

#include <fmt/format.h>

namespace talus::output {
namespace {

template <class T>
std::string write_array(const std::string& name, const char* type, int components, const std::vector<T>& values) {
  std::string text;
  for (const T v : values) text += fmt::format(" {}", v);
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">{}</DataArray>\n",
                     type, name, components, text);
}

std::string write_fields(const std::vector<VtuField>& fields) {
  std::string text;
  for (const VtuField& field : fields)
    text += write_array(field.name, field.is_integer ? "Int32" : "Float64", field.components, field.values);
  return text;
}

}  // namespace

std::string write_vtu(const VtuMesh& mesh) {
  const std::size_t cells = mesh.nodes.size() / mesh.per_cell;
  std::vector<std::size_t> offsets;
  for (std::size_t e = 1; e <= cells; ++e) offsets.push_back(mesh.per_cell * e);
  const std::vector<int> types(cells, static_cast<int>(mesh.cell));
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n<UnstructuredGrid>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n{}</Points>\n<Cells>\n{}{}{}</Cells>\n"
      "<PointData>\n{}</PointData>\n<CellData>\n{}</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
      mesh.points.size() / 3, cells, write_array("points", "Float64", 3, mesh.points),
      write_array("connectivity", "Int32", 1, mesh.nodes), write_array("offsets", "Int32", 1, offsets),
      write_array("types", "UInt8", 1, types), write_fields(mesh.point_fields), write_fields(mesh.cell_fields));
}

}  // namespace talus::output
