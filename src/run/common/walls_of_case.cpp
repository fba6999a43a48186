// SPDX-License-Identifier: MIT
#include "run/common/walls_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "base/error.hpp"
#include "input/case/support_places.hpp"
#include "mesh/generate.hpp"
#include "mesh/planar.hpp"
#include "mesh/split.hpp"
#include "run/common/bars_of_case.hpp"
#include "run/common/head.hpp"
#include "run/common/wall_checks.hpp"
#include "site/ground_load.hpp"
#include "site/seepage_model.hpp"
#include "site/supports.hpp"

namespace talus::run {

namespace {

/// A point of a wall within this fraction of the width of the section lies on the ground, and the head of a bar on a
/// wall.
constexpr double near_ground = 1e-3, near_wall = 1e-3;
/// Distance of nodes from the line of a wall, over the extent of the mesh, at which they lie on it.
constexpr double on_line = 1e-7;
/// Stiffness of an interface over Young's modulus of the softest soil beside it [1/m]: that of a layer of 10 mm.
constexpr double interface_share = 100;
/// Tangential over normal stiffness of an interface: G/E with ν = 0.3.
constexpr double shear_joint = 1 / 2.6;
/// Utilisation from which an interface slips.
constexpr double slips = 0.999;

/// Returns the place of a point on the ground: the nearest corner or the foot of the perpendicular, if it is near.
site::Point snap(const site::Point& p, const site::Polyline& ground) {
  const double near = near_ground * (ground.back()[0] - ground.front()[0]);
  for (const site::Point& corner : ground)
    if (std::hypot(p[0] - corner[0], p[1] - corner[1]) <= near) return corner;
  const site::Point foot = find_nearest(ground, p);
  return std::hypot(p[0] - foot[0], p[1] - foot[1]) <= near ? foot : p;
}

/// Adds a place to a line, between its points; one that nearly coincides with a point is left out.
void insert(site::Polyline& line, const site::Point& place, double near) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (mesh::compute_distance(place, line[i - 1], line[i]) > near) continue;
    if (std::hypot(place[0] - line[i - 1][0], place[1] - line[i - 1][1]) <= near ||
        std::hypot(place[0] - line[i][0], place[1] - line[i][1]) <= near)
      return;
    line.insert(line.begin() + static_cast<std::ptrdiff_t>(i), place);
    return;
  }
}

/// Returns the nodes of a mesh on a line, in its direction.
std::vector<int> list_nodes(const WallLine& wall, const mesh::Mesh<2>& mesh, const ShownUnits& units) {
  double extent = 0;
  for (const auto& x : mesh.nodes)
    extent = std::max({extent, std::abs(x[0] - mesh.nodes[0][0]), std::abs(x[1] - mesh.nodes[0][1])});
  const double near = on_line * extent;
  std::vector<std::pair<double, int>> found;
  double before = 0;
  for (std::size_t i = 0; i + 1 < wall.points.size(); ++i) {
    const site::Point &a = wall.points[i], &b = wall.points[i + 1];
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
    for (int n = 0; n < mesh.node_count(); ++n) {
      const auto& x = mesh.nodes[n];
      if (mesh::compute_distance(x, a, b) > near) continue;
      const double s = ((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / length;
      if (i == 0 || s > near) found.emplace_back(before + s, n);
    }
    before += length;
  }
  std::sort(found.begin(), found.end());
  std::set<std::pair<int, int>> edges;
  for (const auto& e : mesh.elements)
    for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax(e[i], e[(i + 1) % 3]));
  std::vector<int> nodes;
  for (const auto& [s, n] : found) nodes.push_back(n);
  bool conforms = found.size() > 1 && found.front().first <= near && found.back().first >= before - near;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    conforms = conforms && edges.contains(std::minmax(nodes[i], nodes[i + 1]));
  if (!conforms)
    throw Error(ExitCode::wrong_input,
                fmt::format("the mesh does not conform to wall '{}' from {} to {}: its line must consist of edges of "
                            "the mesh",
                            wall.support, format_point(wall.points.front(), units.length),
                            format_point(wall.points.back(), units.length)));
  return nodes;
}

using InterfaceLaw = std::function<fem::InterfaceStrength(const Vec<2>&)>;

/// Returns the strength of the interface to each region of a mesh.
std::vector<InterfaceLaw> list_interfaces(const site::Site& site, const input::Support& support,
                                          const std::string& name, const std::vector<std::string>& regions) {
  std::vector<InterfaceLaw> laws;
  for (const std::string& region : regions) {
    if (!support.interface_strength) {
      const fem::InterfaceStrength given{support.bond_adhesion.value_or(0),
                                         support.bond_scale * std::tan(support.bond_friction.value_or(0))};
      laws.emplace_back([given](const Vec<2>&) { return given; });
      continue;
    }
    const input::Material soil = input::find_limit_soil(site.get_soil(region));
    const std::string model = soil.traits().word;
    const bool has_strength = model == "mohr_coulomb" || model == "tresca";
    const site::PlaneStrength own = has_strength ? site::find_plane_strength(soil) : site::PlaneStrength{};
    if (!has_strength || own.law)
      throw Error(ExitCode::wrong_input,
                  fmt::format("wall '{}': 'interface_strength' is a fraction of c and φ, which material '{}' with {} "
                              "does not have; give 'bond_adhesion' and 'bond_friction'",
                              name, site.data().regions.at(region),
                              has_strength ? "a profile of strengths" : "the model " + model));
    laws.emplace_back([own, share = *support.interface_strength](const Vec<2>& x) {
      const double cohesion = own.cohesion + own.cohesion_gradient * std::max(0.0, own.cohesion_level - x[1]);
      return fem::InterfaceStrength{share * cohesion, share * std::tan(own.friction_angle)};
    });
  }
  return laws;
}

double find_softest(const site::Site& site) {
  double young = fem::unlimited;
  for (const auto& [region, material] : site.data().regions)
    if (const double own = site.get_soil(region).young_modulus; own > 0) young = std::min(young, own);
  return young;
}

results::ElementFace make_face_result(std::vector<fem::FacePoint> points) {
  std::stable_sort(points.begin(), points.end(),
                   [](const fem::FacePoint& a, const fem::FacePoint& b) { return a.place < b.place; });
  results::ElementFace face;
  for (const fem::FacePoint& p : points) {
    face.place.push_back(round_to(p.place, 1e6));
    face.normal.push_back(round_to(p.normal, force_digits));
    face.shear.push_back(round_to(p.shear, force_digits));
  }
  return face;
}

}  // namespace

std::vector<WallLine> list_walls(const site::Site& site) {
  std::vector<WallLine> walls;
  for (const site::Bar& bar : site::list_bars(site)) {
    if (bar.kind != input::SupportKind::wall) continue;
    const site::Point head = snap(bar.head, site.ground()), end = snap(bar.end, site.ground());
    const bool goes_on = !walls.empty() && walls.back().support == bar.support && walls.back().row == bar.row;
    if (!goes_on) walls.push_back({bar.support, bar.row, {head}});
    walls.back().points.push_back(end);
  }
  check_walls(site, walls);
  return walls;
}

std::optional<std::size_t> find_wall(const site::Site& site, const std::vector<WallLine>& walls, const site::Point& p) {
  const double near = near_wall * (site.ground().back()[0] - site.ground().front()[0]);
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (mesh::compute_distance(p, walls[w].points) <= near) return w;
  return std::nullopt;
}

site::Point find_nearest(const site::Polyline& line, const site::Point& p) {
  site::Point nearest = line.front();
  double least = fem::unlimited;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const site::Point &a = line[i - 1], &b = line[i];
    const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
    const site::Point foot{a[0] + t * dx, a[1] + t * dy};
    const double distance = std::hypot(p[0] - foot[0], p[1] - foot[1]);
    if (distance < least) least = distance, nearest = foot;
  }
  return nearest;
}

mesh::Plan conform_to_walls(const site::Site& site, mesh::Plan plan, const std::vector<site::Point>& more) {
  if (plan.dimension != 2 || !plan.file.empty() || plan.polygons.empty()) return plan;
  const std::vector<WallLine> walls = list_walls(site);
  return walls.empty() ? plan : conform_to_walls(walls, input::measure_width(site.ground()), std::move(plan), more);
}

mesh::Plan conform_to_walls(const std::vector<WallLine>& walls, double width, mesh::Plan plan,
                            const std::vector<site::Point>& more) {
  std::vector<site::Point> places;
  for (const WallLine& wall : walls) {
    site::Polyline points = wall.points;
    for (const site::Point& place : more) insert(points, place, mesh::get_tolerance(plan));
    places.insert(places.end(), points.begin(), points.end());
    plan.lines.push_back({fmt::format("[support.{}] {}", wall.support, wall.row), points});
  }
  return site::add_corners(std::move(plan), places, 1e-9 * width);
}

bool has_impermeable_walls(const input::Case& data) {
  return std::any_of(data.supports.begin(), data.supports.end(), [](const auto& entry) {
    return entry.second.kind == input::SupportKind::wall && !entry.second.permeable.value_or(true);
  });
}

bool has_rough_walls(const input::Case& data) {
  return std::any_of(data.supports.begin(), data.supports.end(), [](const auto& entry) {
    const input::Support& s = entry.second;
    return s.kind == input::SupportKind::wall &&
           (s.interface_strength || s.bond_adhesion.value_or(0) > 0 || s.bond_friction.value_or(0) > 0);
  });
}

mesh::Mesh<2> cut_at_walls(const site::Site& site, mesh::Mesh<2> mesh) {
  if (!has_impermeable_walls(site.data())) return mesh;
  mesh::Cuts cuts;
  for (const WallLine& line : list_walls(site)) {
    if (site.data().supports.at(line.support).permeable.value_or(true)) continue;
    const std::vector<int> nodes = list_nodes(line, mesh, site.data().units());
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) cuts.push_back({nodes[i], nodes[i + 1]});
  }
  return mesh::split(std::move(mesh), cuts, site::impermeable_sides);
}

template <int D>
mesh::Mesh<D> generate_for_seepage(const site::Site& site) {
  const mesh::Plan& plan = site.data().mesh;
  if (!has_impermeable_walls(site.data())) return mesh::generate<D>(plan);
  return cut_at_walls(site, mesh::generate<D>(conform_to_walls(site, plan)));
}
template mesh::Mesh<2> generate_for_seepage<2>(const site::Site&);
template mesh::Mesh<3> generate_for_seepage<3>(const site::Site&);

std::vector<fem::Wall> make_walls(const site::Site& site, const mesh::Mesh<2>& mesh) {
  std::vector<fem::Wall> walls;
  for (const WallLine& line : list_walls(site)) {
    const input::Support& support = site.data().supports.at(line.support);
    fem::Wall& wall = walls.emplace_back();
    wall.name = line.support;
    wall.nodes = list_nodes(line, mesh, site.data().units());
    wall.axial_stiffness = support.axial_stiffness.value_or(0);
    wall.axial = support.plastic_force.value_or(fem::unlimited);
    wall.bending_stiffness = support.bending_stiffness.value_or(0);
    wall.shear_stiffness = shear_share * wall.axial_stiffness;
    wall.moment = support.plastic_moment.value_or(fem::unlimited);
    wall.shear = support.shear_strength.value_or(fem::unlimited);
    wall.normal_stiffness = interface_share * find_softest(site);
    wall.tangential_stiffness = shear_joint * wall.normal_stiffness;
    const Vec<2> pull = site.find_body_force<2>();
    for (std::size_t d = 0; d < 2; ++d) wall.line_load[d] = support.weight.value_or(0) * pull[d];
    wall.interface = [laws = list_interfaces(site, support, line.support, mesh.region_names)](
                         int region, const Vec<2>& x) { return laws[static_cast<std::size_t>(region)](x); };
    for (const double level : support.strut_levels)
      wall.struts.push_back({level, *support.strut_stiffness, support.strut_strength, support.strut_prestress});
  }
  return walls;
}

results::ElementBar make_wall_result(const WallLine& wall, const fem::BarForces& failed, const fem::BarForces& start) {
  results::ElementBar out = make_bar_result(failed, start);
  out.support = wall.support;
  out.kind = input::get_word(input::SupportKind::wall);
  out.row = wall.row;
  out.head = wall.points.front();
  out.end = wall.points.back();
  out.line = wall.points;
  out.largest = 0;
  for (const double n : out.force)
    if (std::abs(n) > std::abs(out.largest)) out.largest = n;
  std::size_t sliding = 0, all = 0;
  for (const auto& face : failed.face)
    for (const fem::FacePoint& p : face) ++all, sliding += std::abs(p.shear) >= slips * p.strength;
  if (!start.deflection.place.empty()) {
    out.deflection.emplace();
    for (std::size_t i = 0; i < start.deflection.place.size(); ++i) {
      out.deflection->place.push_back(round_to(start.deflection.place[i], 1e6));
      out.deflection->value.push_back(round_to(start.deflection.value[i], 1e9));
    }
  }
  if (all > 0) out.sliding = static_cast<double>(sliding) / static_cast<double>(all);
  if (!failed.face[0].empty()) out.left = make_face_result(failed.face[0]);
  if (!failed.face[1].empty()) out.right = make_face_result(failed.face[1]);
  if (!failed.strut.value.empty()) {
    out.struts.emplace();
    for (const double n : failed.strut.value) out.struts->push_back(round_to(n, force_digits));
  }
  return out;
}

}  // namespace talus::run
