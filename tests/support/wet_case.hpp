// SPDX-License-Identifier: MIT
#pragma once
// Cases with pore water on a box, without a mesh generator: one soil, its water, and ground with a step.

#include "support/box_case.hpp"

namespace talus::support {

/// Elastic, saturated, n = 0.4.
inline input::Material make_wet_soil(double young_modulus = 10e6) {
  input::Material soil = make_elastic(young_modulus, 0.3, 2650);
  soil.porosity = 0.4;
  soil.water.retention = input::RetentionCurve::saturated;
  soil.water.conductivity = 1e-4;
  return soil;
}

inline input::TimeTable make_constant(double value) {
  return {{0.0}, {value}};
}

inline input::Hydraulic make_hydraulic(const std::string& on, input::WaterCondition condition, double value = 0) {
  input::Hydraulic h;
  h.on = on;
  h.condition = condition;
  h.head = h.pressure = h.rate = make_constant(value);
  return h;
}

/// Names the sides between elements whose nodes all satisfy `chosen`.
template <int D>
void name_line(mesh::Mesh<D>& mesh, const std::string& name,
               const std::type_identity_t<std::function<bool(const Vec<D>&)>>& chosen) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    for (std::size_t k = 0; k <= D; ++k) {
      if (mesh.neighbours[e][k] < static_cast<int>(e)) continue;
      typename mesh::Mesh<D>::Side side;
      std::size_t n = 0;
      bool all = true;
      for (std::size_t j = 0; j <= D; ++j) {
        if (j == k) continue;
        side[n++] = mesh.elements[e][j];
        all = all && chosen(mesh.nodes[static_cast<std::size_t>(mesh.elements[e][j])]);
      }
      if (all) mesh.sides[name].push_back(side);
    }
  }
}

/// 4 m × 3 m (× 1 m): ground at y = 2 m ("crest") up to x = 2 m, at y = 1 m ("foot") beyond it, a cliff without a name
/// between them.
template <int D>
mesh::Mesh<D> make_step_mesh() {
  std::array<int, D> cells{};
  Vec<D> size{};
  for (std::size_t d = 0; d < D; ++d) {
    cells[d] = std::array{8, 6, 2}[d];
    size[d] = std::array{4.0, 3.0, 1.0}[d];
  }
  const auto region = [](const Vec<D>& x) { return x[1] < (x[0] < 2 ? 2 : 1) ? 0 : -1; };
  mesh::Mesh<D> mesh = make_box_mesh<D>(cells, size, {"soil"}, region, 0);
  name_line<D>(mesh, "crest", [](const Vec<D>& x) { return std::abs(x[1] - 2) < 1e-9 && x[0] < 2 + 1e-9; });
  name_line<D>(mesh, "foot", [](const Vec<D>& x) { return std::abs(x[1] - 1) < 1e-9 && x[0] > 2 - 1e-9; });
  return mesh;
}

/// Number of the node at `x`.
template <int D>
int find_node(const mesh::Mesh<D>& mesh, const std::type_identity_t<Vec<D>>& x) {
  for (int i = 0; i < mesh.node_count(); ++i) {
    double square = 0;
    for (std::size_t d = 0; d < D; ++d) square += std::pow(mesh.nodes[static_cast<std::size_t>(i)][d] - x[d], 2);
    if (square < 1e-18) return i;
  }
  return -1;
}

}  // namespace talus::support
