// SPDX-License-Identifier: MIT
// A slope to be meshed, and measures of a mesh, for the tests of plans and of meshes.
#pragma once

#include <cmath>
#include <string>

#include "mesh/generate.hpp"

namespace talus::mesh {

inline Plan plan_slope(double size) {
  Plan plan;
  plan.box_max = {44, 17};
  plan.size = size;
  plan.polygons = {{"soil", {{0, 0}, {44, 0}, {44, 5}, {32, 5}, {12, 15}, {0, 15}}}};
  return plan;
}

template <int D>
double sum_region(const Mesh<D>& mesh, int region) {
  double sum = 0;
  for (int e = 0; e < mesh.element_count(); ++e)
    if (mesh.element_region[e] == region) sum += mesh.volumes[e];
  return sum;
}

inline double measure_length(const Mesh<2>& mesh, const std::string& name) {
  double length = 0;
  for (const auto& [a, b] : mesh.sides.at(name))
    length += std::hypot(mesh.nodes[a][0] - mesh.nodes[b][0], mesh.nodes[a][1] - mesh.nodes[b][1]);
  return length;
}

}  // namespace talus::mesh
