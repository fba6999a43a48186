// SPDX-License-Identifier: MIT
#include "mesh/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "base/abandon.hpp"
#include "base/error.hpp"
#include "mesh/check_plan.hpp"
#include "mesh/gmsh_mesh.hpp"
#include "mesh/gmsh_session.hpp"
#include "mesh/planar.hpp"

namespace talus::mesh {
namespace {

/// The innermost polygon around a place: a lens replaces what it lies in.
int find_region(const Plan& plan, const Point2& x) {
  int region = empty_region;
  double smallest = 0;
  for (std::size_t i = 0; i < plan.polygons.size(); ++i) {
    const auto& corners = plan.polygons[i].points;
    const double area = std::abs(compute_area(corners));
    if (is_inside(x, corners) && (region == empty_region || area < smallest)) {
      region = static_cast<int>(i);
      smallest = area;
    }
  }
  return region;
}

template <int D>
std::vector<std::string> find_sides(const Plan& plan, const std::array<double, 3>& x) {
  const double near = get_tolerance(plan);
  std::vector<std::string> names;
  const auto add = [&](const char* name, double value, double wall) {
    if (std::abs(value - wall) <= near) names.emplace_back(name);
  };
  add("left", x[0], plan.box_min[0]);
  add("right", x[0], plan.box_max[0]);
  add("bottom", x[1], plan.box_min[1]);
  add("top", x[1], plan.box_max[1]);
  if constexpr (D == 3) {
    add("front", x[2], 0);
    add("back", x[2], plan.thickness);
  }
  for (const Line& l : plan.lines)
    if (compute_distance({x[0], x[1]}, l.points) <= near) names.push_back(l.name);
  return names;
}

/// The geometry kernel keeps points to 1e-7 m only: nodes on a side or at a corner are put there exactly.
template <int D>
void put_in_place(Mesh<D>& mesh, const Plan& plan) {
  const double near = get_tolerance(plan);
  Polyline corners;
  for (const Polygon& p : plan.polygons) corners.insert(corners.end(), p.points.begin(), p.points.end());
  for (const Line& l : plan.lines) corners.insert(corners.end(), l.points.begin(), l.points.end());
  for (auto& x : mesh.nodes) {
    for (const Point2& c : corners)
      if (std::hypot(x[0] - c[0], x[1] - c[1]) <= near) {
        x[0] = c[0];
        x[1] = c[1];
      }
    for (int d = 0; d < D; ++d)
      for (double wall : {d == 2 ? 0 : plan.box_min[d], d == 2 ? plan.thickness : plan.box_max[d]})
        if (std::abs(x[d] - wall) <= near) x[d] = wall;
  }
}

template <int D>
Mesh<D> mesh_plan(const Plan& given) {
  const Plan plan = check_plan(given);
  const GmshSession session;
  try {
    mesh_with_gmsh(plan);
  } catch (...) {  // Gmsh throws strings and numbers
    throw Error(ExitCode::wrong_input, "Gmsh cannot mesh the plan: " + GmshSession::get_last_error());
  }
  Naming naming;
  naming.region = [&](int, const std::array<double, 3>& x) { return find_region(plan, {x[0], x[1]}); };
  naming.sides = [&](int, const std::array<double, 3>& x) { return find_sides<D>(plan, x); };
  Mesh<D> mesh = extract_mesh<D>(naming);
  for (const Polygon& p : plan.polygons) mesh.region_names.push_back(p.name);
  raise_altitudes<D>(mesh, extract_freedoms<D>(), [&](const auto& x) { return compute_size(plan, {x[0], x[1]}); });
  put_in_place(mesh, plan);
  return mesh;
}

/// Gmsh does not always say when it leaves a part out.
template <int D>
void check_whole(const Mesh<D>& mesh, const Plan& plan) {
  const double box =
      (plan.box_max[0] - plan.box_min[0]) * (plan.box_max[1] - plan.box_min[1]) * (D == 3 ? plan.thickness : 1);
  const double meshed = std::accumulate(mesh.volumes.begin(), mesh.volumes.end(), 0.0);
  if (!(std::abs(meshed - box) < 1e-6 * box))
    throw Error(ExitCode::wrong_input,
                fmt::format("Gmsh meshed {:.6g} of the box's {:.6g} {}: look for edges or lines that nearly touch, or "
                            "ask for smaller elements",
                            meshed, box, D == 2 ? "m²" : "m³"));
}

}  // namespace

template <int D>
Mesh<D> generate(const Plan& plan) {
  if (plan.dimension != D)
    throw Error(ExitCode::internal_error, fmt::format("a {}D plan was given to the {}D mesher", plan.dimension, D));
  // Gmsh looks for no interruptions. What it works on belongs to the job, which may outlive this call.
  const auto mesh = std::make_shared<Mesh<D>>();
  do_or_abandon("the mesh was made", [mesh, plan] {
    *mesh = plan.file.empty() ? mesh_plan<D>(plan) : read_mesh_file<D>(plan.file);
    finish(*mesh);
    if (plan.file.empty()) check_whole(*mesh, plan);
  });
  return std::move(*mesh);
}

template Mesh<2> generate<2>(const Plan&);
template Mesh<3> generate<3>(const Plan&);

}  // namespace talus::mesh
