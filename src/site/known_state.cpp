// SPDX-License-Identifier: MIT
// Interpolation of the stress and the pore water of an earlier result.
#include "site/known_state.hpp"

#include <algorithm>

#include "mesh/locate.hpp"
#include "site/seepage_model.hpp"

namespace talus::site {

StressReader::StressReader(const input::KnownStress& known, const mesh::Mesh<2>& mesh)
    : known_(known), mesh_(mesh), same_mesh_(mesh.nodes == known.mesh.nodes && mesh.elements == known.mesh.elements) {}

/// Returns the nearest triangle with soil: near the ground a point of one mesh may lie outside the soil of another.
int StressReader::find_soil(const Vec<2>& x) const {
  const mesh::Mesh<2>& mesh = known_.mesh;
  const int found = mesh::find_element(mesh, x, last_);
  if (found >= 0 && mesh.element_region[static_cast<std::size_t>(found)] != mesh::empty_region) return found;
  int nearest = 0;
  double greatest = -1e300;
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (mesh.element_region[static_cast<std::size_t>(e)] == mesh::empty_region) continue;
    const auto xi = mesh::to_local(mesh, e, x);
    const double least = std::min({xi[0], xi[1], 1 - xi[0] - xi[1]});
    if (least > greatest) greatest = least, nearest = e;
  }
  return nearest;
}

StressAt StressReader::read(int e, const Vec<2>& xi) {
  Vec<2> at = xi;
  if (!same_mesh_) {
    const Vec<2> x = mesh::to_global(mesh_, e, xi);
    e = last_ = find_soil(x);
    at = mesh::to_local(known_.mesh, e, x);
  }
  const std::array<double, 3> corner{1 - at[0] - at[1], at[0], at[1]};
  const auto& element = known_.elements[static_cast<std::size_t>(e)];
  StressAt here;
  // The linear field through the values at the integration points, where one coordinate is 2/3 and the others are 1/6.
  for (std::size_t q = 0; q < corner.size(); ++q)
    for (std::size_t k = 0; k < here.stress.size(); ++k)
      here.stress[k] += (2 * corner[q] - 1.0 / 3) * element.stress[q][k];
  const auto nearest = std::max_element(corner.begin(), corner.end()) - corner.begin();
  here.plastic_strain = element.plastic_strain[static_cast<std::size_t>(nearest)];
  return here;
}

namespace {

/// Part of the way from a node to the middle of an element.
constexpr double towards_middle = 1e-6;

/// Returns the element that contains `x`, or the one whose smallest shape function at x is largest.
int find_nearest_element(const mesh::Mesh<2>& mesh, const Vec<2>& x, int start) {
  const int found = mesh::find_element(mesh, x, start);
  if (found >= 0) return found;
  int nearest = 0;
  double greatest = -1e300;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const auto xi = mesh::to_local(mesh, e, x);
    const double least = std::min({xi[0], xi[1], 1 - xi[0] - xi[1]});
    if (least > greatest) greatest = least, nearest = e;
  }
  return nearest;
}

}  // namespace

MappedWater map_water(const input::KnownWater& known, const mesh::Mesh<2>& mesh) {
  if (mesh.nodes == known.mesh.nodes && mesh.elements == known.mesh.elements) return {known.pressure, known.seepage};
  MappedWater water;
  // Both nodes on an impermeable wall have one place; a point in an element of the node lies on its side of the wall.
  const bool is_cut = mesh.sides.contains(impermeable_sides);
  std::vector<Vec<2>> places = mesh.nodes;
  for (int i = 0; is_cut && i < mesh.element_count(); ++i) {
    const Vec<2> middle = mesh::to_global(mesh, i, Vec<2>{1.0 / 3, 1.0 / 3});
    for (const int n : mesh.elements[static_cast<std::size_t>(i)])
      for (std::size_t d = 0; d < 2; ++d)
        places[static_cast<std::size_t>(n)][d] = mesh.nodes[n][d] + towards_middle * (middle[d] - mesh.nodes[n][d]);
  }
  int e = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Vec<2>& x = mesh.nodes[n];
    e = find_nearest_element(known.mesh, places[n], e);
    const auto xi = mesh::to_local(known.mesh, e, x);
    const auto& corners = known.mesh.elements[static_cast<std::size_t>(e)];
    const auto at = [&](std::size_t c) { return known.pressure[static_cast<std::size_t>(corners[c])]; };
    water.pressure.push_back((1 - xi[0] - xi[1]) * at(0) + xi[0] * at(1) + xi[1] * at(2));
  }
  for (int i = 0; i < mesh.element_count(); ++i) {
    e = find_nearest_element(known.mesh, mesh::to_global(mesh, i, Vec<2>{1.0 / 3, 1.0 / 3}), e);
    water.seepage.push_back(known.seepage[static_cast<std::size_t>(e)]);
  }
  return water;
}

}  // namespace talus::site
