// SPDX-License-Identifier: MIT
#include "run/fem/fields_vtu.hpp"

#include "output/files/vtu.hpp"

namespace talus::run {
namespace {

/// Returns vectors with three components in any dimension.
std::vector<double> list_vectors(const std::vector<std::vector<double>>& rows) {
  std::vector<double> values;
  for (const std::vector<double>& row : rows)
    for (std::size_t d = 0; d < 3; ++d) values.push_back(d < row.size() ? row[d] : 0.0);
  return values;
}

template <class T>
std::vector<double> list_numbers(const std::vector<T>& values) {
  return {values.begin(), values.end()};
}

}  // namespace

std::string write_vtu(const results::ElementMesh& file) {
  output::VtuMesh mesh;
  mesh.per_cell = file.elements.empty() ? 6 : file.elements[0].size();
  mesh.cell = mesh.per_cell == 6 ? output::VtuCell::quadratic_triangle : output::VtuCell::quadratic_tetrahedron;
  mesh.points = list_vectors(file.nodes);
  for (const auto& element : file.elements) mesh.nodes.insert(mesh.nodes.end(), element.begin(), element.end());
  for (const results::ElementFields& run : file.runs) {
    const std::string flow = results::to_word(run.flow);
    mesh.point_fields.push_back({"displacement_" + flow, 3, list_vectors(run.displacement)});
    mesh.point_fields.push_back({"shear_strain_" + flow, 1, list_numbers(run.shear_strain)});
    mesh.cell_fields.push_back({"yields_" + flow, 1, list_numbers(run.yields), true});
  }
  return output::write_vtu(mesh);
}

}  // namespace talus::run
