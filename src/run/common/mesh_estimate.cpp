// SPDX-License-Identifier: MIT
#include "run/common/mesh_estimate.hpp"

#include <algorithm>
#include <numbers>

#include "mesh/gmsh_mesh.hpp"
#include "mesh/planar.hpp"

namespace talus::run {

namespace {

constexpr int places = 200;
/// Area of an equilateral triangle over the square of its side.
constexpr double triangle = std::numbers::sqrt3 / 4;
/// The same for tetrahedra by Gmsh: 0.176 to 0.201 on slopes of 5,000 to 65,000 elements. A regular tetrahedron has
/// 0.118.
constexpr double tetrahedron = 0.19;

}  // namespace

ElementCount count_elements(const mesh::Plan& plan) {
  ElementCount count;
  if (!plan.file.empty() || !(plan.size > 0)) return count;
  const double width = (plan.box_max[0] - plan.box_min[0]) / places,
               height = (plan.box_max[1] - plan.box_min[1]) / places;
  for (int i = 0; i < places; ++i)
    for (int j = 0; j < places; ++j) {
      const mesh::Point2 x{plan.box_min[0] + (i + 0.5) * width, plan.box_min[1] + (j + 0.5) * height};
      const double size = plan.refinements.empty() ? plan.size : mesh::compute_size(plan, x);
      const double here = plan.dimension == 2 ? width * height / (triangle * size * size)
                                              : width * height * plan.thickness / (tetrahedron * size * size * size);
      count.all += here;
      if (std::any_of(plan.polygons.begin(), plan.polygons.end(),
                      [&](const mesh::Polygon& polygon) { return mesh::is_inside(x, polygon.points); }))
        count.soil += here;
    }
  return count;
}

double find_smallest_size(const mesh::Plan& plan) {
  double size = plan.size;
  for (const mesh::Refinement& r : plan.refinements) size = std::min(size, r.size);
  return size;
}

bool is_meshed_in_a_moment(const mesh::Plan& plan) {
  constexpr std::size_t most_corners = 500, most_parts = 50;
  std::size_t corners = 0;
  for (const mesh::Polygon& polygon : plan.polygons) corners += polygon.points.size();
  for (const mesh::Line& line : plan.lines) corners += line.points.size();
  return corners <= most_corners && plan.polygons.size() + plan.lines.size() <= most_parts;
}

}  // namespace talus::run
