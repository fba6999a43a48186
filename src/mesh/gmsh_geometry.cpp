// SPDX-License-Identifier: MIT
// The polygons, lines and element sizes of a plan as Gmsh's geometry, and the mesh that Gmsh makes of it.

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <unordered_map>

#include "mesh/gmsh_mesh.hpp"
#include "mesh/planar.hpp"

namespace talus::mesh {
namespace {

namespace occ = gmsh::model::occ;

/// A mesh whose number of triangles is this near to the wanted one is not made again.
constexpr double count_tolerance = 0.01;

std::vector<int> add_polyline(const Polyline& line) {
  std::vector<int> points, curves;
  for (const Point2& x : line) points.push_back(occ::addPoint(x[0], x[1], 0));
  for (std::size_t i = 0; i + 1 < points.size(); ++i) curves.push_back(occ::addLine(points[i], points[i + 1]));
  return curves;
}

int add_surface(const Polyline& corners) {
  std::vector<int> points, curves;
  for (const Point2& x : corners) points.push_back(occ::addPoint(x[0], x[1], 0));
  for (std::size_t i = 0; i < points.size(); ++i)
    curves.push_back(occ::addLine(points[i], points[(i + 1) % points.size()]));
  return occ::addPlaneSurface({occ::addCurveLoop(curves)});
}

/// `entities` drawn along z over `thickness`; only what has one dimension more is kept of the result.
gmsh::vectorpair extrude(const gmsh::vectorpair& entities, double thickness) {
  gmsh::vectorpair drawn, kept;
  for (const auto& entity : entities) {
    occ::extrude({entity}, 0, 0, thickness, drawn);
    for (const auto& d : drawn)
      if (d.first == entity.first + 1) kept.push_back(d);
  }
  return kept;
}

/// Cuts box, polygons and lines at each other, so that the mesh conforms to all of them.
void build_geometry(const Plan& plan) {
  const auto [x0, y0] = plan.box_min;
  const auto [x1, y1] = plan.box_max;
  gmsh::vectorpair box{{2, add_surface({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}})}}, parts;
  for (const Polygon& p : plan.polygons) parts.emplace_back(2, add_surface(p.points));
  for (const Line& l : plan.lines)
    for (int curve : add_polyline(l.points)) parts.emplace_back(1, curve);
  if (plan.dimension == 3) {
    box = extrude(box, plan.thickness);
    parts = extrude(parts, plan.thickness);
    occ::synchronize();
  }
  if (!parts.empty()) {
    gmsh::vectorpair fragments;
    std::vector<gmsh::vectorpair> origin;
    occ::fragment(box, parts, fragments, origin);
  }
  occ::synchronize();
}

int get_algorithm(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::meshadapt:
      return 1;
    case Algorithm::delaunay:
      return 5;
    case Algorithm::frontal:
      break;
  }
  return 6;
}

/// The number of triangles over that of equilateral triangles of the wanted size on the same area. Gmsh divides every
/// edge into parts no longer than the size, so coarse meshes come out finer than asked for (3 % on a slope of 60
/// elements' length, 15 % with the Delaunay algorithm).
double measure_surplus(const Plan& plan) {
  std::vector<std::size_t> tags, corners;
  gmsh::model::mesh::getElementsByType(2, tags, corners);
  std::vector<double> places, parametric;
  std::vector<std::size_t> nodes;
  gmsh::model::mesh::getNodes(nodes, places, parametric, -1, -1, false, false);
  std::unordered_map<std::size_t, Point2> by_tag;
  for (std::size_t i = 0; i < nodes.size(); ++i) by_tag[nodes[i]] = {places[3 * i], places[3 * i + 1]};
  double wanted = 0;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Point2 &a = by_tag[corners[i]], &b = by_tag[corners[i + 1]], &c = by_tag[corners[i + 2]];
    const double size = compute_size(plan, {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3});
    wanted += std::abs(compute_area({a, b, c})) / (std::numbers::sqrt3 / 4 * size * size);
  }
  return static_cast<double>(tags.size()) / wanted;
}

}  // namespace

double compute_size(const Plan& plan, const Point2& x) {
  double size = plan.size;
  for (const Refinement& r : plan.refinements) {
    const double share = std::min(1.0, compute_distance(x, r.near) / r.distance);
    size = std::min(size, r.size + share * (plan.size - r.size));
  }
  return size;
}

void mesh_with_gmsh(const Plan& plan) {
  gmsh::model::add("plan");
  build_geometry(plan);
  // The size comes from the plan alone: nothing spreads from short edges or from CAD points.
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeFromCurvature", 0);
  gmsh::option::setNumber("Mesh.Algorithm", get_algorithm(plan.algorithm));
  double scale = 1;
  const bool uniform = plan.refinements.empty();
  const std::function<double(int, int, double, double, double)> get_size = [&](int, int, double x, double y, double) {
    return scale * compute_size(plan, {x, y});
  };
  if (!uniform) gmsh::model::mesh::setSizeCallback(get_size);
  for (int attempt = 0; attempt < 3; ++attempt) {
    gmsh::option::setNumber("Mesh.MeshSizeMax", scale * plan.size);
    gmsh::model::mesh::generate(plan.dimension);
    if (plan.dimension == 3) break;
    const double surplus = measure_surplus(plan);
    if (std::abs(surplus - 1) < count_tolerance) break;
    if (attempt == 2) break;
    scale *= std::sqrt(surplus);
    gmsh::model::mesh::clear();
  }
  if (!uniform) gmsh::model::mesh::removeSizeCallback();
}

}  // namespace talus::mesh
