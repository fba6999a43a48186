// SPDX-License-Identifier: MIT
#include "support/solid_model.hpp"

namespace talus::support {

template <int D>
std::vector<std::array<int, D>> find_sides(const mesh::Mesh<D>& mesh,
                                           const std::function<bool(const Vec<D>&)>& wanted) {
  std::vector<std::array<int, D>> sides;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (mesh.element_region[e] == mesh::empty_region) continue;
    for (std::size_t k = 0; k <= D; ++k) {
      const int across = mesh.neighbours[e][k];
      if (across >= 0 && mesh.element_region[static_cast<std::size_t>(across)] != mesh::empty_region) continue;
      std::array<int, D> side;
      bool all = true;
      for (std::size_t i = 0, j = 0; i <= D; ++i) {
        if (i == k) continue;
        side[j++] = mesh.elements[e][i];
        all = all && wanted(mesh.nodes[static_cast<std::size_t>(mesh.elements[e][i])]);
      }
      if (all) sides.push_back(side);
    }
  }
  return sides;
}

template <int D>
std::vector<std::array<int, D>> find_sides_at(const mesh::Mesh<D>& mesh, std::size_t axis, double value) {
  return find_sides<D>(mesh, [=](const Vec<D>& x) { return std::abs(x[axis] - value) < 1e-9 * (1 + std::abs(value)); });
}

template <int D>
void add_roller(fem::SolidModel<D>& model, std::size_t axis, double value) {
  fem::Support<D> s;
  s.name = "roller";
  s.sides = find_sides_at<D>(*model.mesh, axis, value);
  s.fixed[axis] = true;
  model.supports.push_back(s);
}

template <int D>
void add_load(fem::SolidModel<D>& model, const std::vector<std::array<int, D>>& sides, const Vec<D>& traction) {
  fem::SurfaceLoad<D> load;
  load.name = "load";
  load.sides = sides;
  std::array<Vec<D>, D> corners;
  corners.fill(traction);
  load.traction.assign(sides.size(), corners);
  model.loads.push_back(load);
}

material::MohrCoulombStrength find_strength(const SoilSection& s) {
  const double tangent = std::tan(s.friction * degree);
  return {s.cohesion, s.friction * degree, s.dilatancy * degree, tangent > 0 ? s.cohesion / tangent : 1e3 * s.cohesion};
}

template std::vector<std::array<int, 2>> find_sides<2>(const mesh::Mesh<2>& mesh,
                                                       const std::function<bool(const Vec<2>&)>& wanted);
template std::vector<std::array<int, 3>> find_sides<3>(const mesh::Mesh<3>& mesh,
                                                       const std::function<bool(const Vec<3>&)>& wanted);
template std::vector<std::array<int, 2>> find_sides_at<2>(const mesh::Mesh<2>& mesh, std::size_t axis, double value);
template std::vector<std::array<int, 3>> find_sides_at<3>(const mesh::Mesh<3>& mesh, std::size_t axis, double value);
template void add_roller<2>(fem::SolidModel<2>& model, std::size_t axis, double value);
template void add_roller<3>(fem::SolidModel<3>& model, std::size_t axis, double value);
template void add_load<2>(fem::SolidModel<2>& model, const std::vector<std::array<int, 2>>& sides,
                          const Vec<2>& traction);
template void add_load<3>(fem::SolidModel<3>& model, const std::vector<std::array<int, 3>>& sides,
                          const Vec<3>& traction);

}  // namespace talus::support
