// SPDX-License-Identifier: MIT
// The mesh of a plan: its geometry in Gmsh (polygons, lines and element sizes) and its meshing.

#include <gmsh.h>

#include <cerrno>
#include <cmath>
#include <functional>
#include <new>
#include <numbers>
#include <unordered_map>

#include "base/error.hpp"
#include "gmsh/session.hpp"
#include "mesh/gmsh_module.hpp"
#include "mesh/planar.hpp"

namespace talus::mesh {

namespace {

namespace occ = gmsh::model::occ;

/// Relative deviation of the number of triangles from the target up to which a mesh is accepted.
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

/// Extrudes `entities` along z over `thickness` and returns only the entities of one dimension more.
gmsh::vectorpair extrude(const gmsh::vectorpair& entities, double thickness) {
  gmsh::vectorpair drawn, kept;
  for (const auto& entity : entities) {
    occ::extrude({entity}, 0, 0, thickness, drawn);
    for (const auto& d : drawn)
      if (d.first == entity.first + 1) kept.push_back(d);
  }
  return kept;
}

/// Intersects box, polygons and lines, so that the mesh conforms to all of them.
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

/// Returns the number of triangles over that of equilateral triangles of the target size on the same area. Gmsh divides
/// every edge into parts no longer than the target size, so coarse meshes are finer than requested (3 % on a slope 60
/// elements long, 15 % with the Delaunay algorithm).
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

void mesh_with_gmsh(const Plan& plan) {
  gmsh::model::add("plan");
  build_geometry(plan);
  // The size follows from the plan alone, not from short edges or CAD points.
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

template <int D>
void mesh_plan(const Plan& plan, const Naming& naming, Mesh<D>& mesh, std::vector<Freedom<D>>& freedoms) {
  const GmshSession session;
  errno = 0;
  try {
    mesh_with_gmsh(plan);
  } catch (...) {  // Gmsh throws strings and numbers
    if (errno == ENOMEM) throw std::bad_alloc();
    fail_input("Gmsh cannot mesh the plan: " + GmshSession::get_last_error());
  }
  mesh = extract_mesh<D>(naming);
  freedoms = extract_freedoms<D>();
}

}  // namespace
}  // namespace talus::mesh

extern "C" void talus_mesh_plan_2(const talus::mesh::Plan& plan, const talus::mesh::Naming& naming,
                                  talus::mesh::Mesh<2>& mesh, std::vector<talus::mesh::Freedom<2>>& freedoms) {
  talus::mesh::mesh_plan<2>(plan, naming, mesh, freedoms);
}
extern "C" void talus_mesh_plan_3(const talus::mesh::Plan& plan, const talus::mesh::Naming& naming,
                                  talus::mesh::Mesh<3>& mesh, std::vector<talus::mesh::Freedom<3>>& freedoms) {
  talus::mesh::mesh_plan<3>(plan, naming, mesh, freedoms);
}
