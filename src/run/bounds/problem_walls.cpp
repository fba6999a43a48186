// SPDX-License-Identifier: MIT
#include "run/bounds/problem_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/error.hpp"
#include "input/case/support.hpp"
#include "run/common/walls_of_case.hpp"
#include "site/supports.hpp"

namespace talus::run {
namespace {

/// Returns the places of a wall at a level.
std::vector<site::Point> find_level(const WallLine& wall, double level) {
  std::vector<site::Point> places;
  for (std::size_t i = 1; i < wall.points.size(); ++i) {
    const site::Point &a = wall.points[i - 1], &b = wall.points[i];
    const double t = a[1] != b[1] ? (level - a[1]) / (b[1] - a[1]) : -1;
    if (t >= 0 && t <= 1) places.push_back({a[0] + t * (b[0] - a[0]), level});
  }
  return places;
}

/// Returns the strut at a level, as in FEM on the side without soil.
bounds::Strut make_strut(const fem::Strut& strut, const fem::Wall& wall, const std::vector<bounds::WallEdge>& edges,
                         const bounds::Problem& problem, const ShownUnit& unit) {
  double least = std::numeric_limits<double>::infinity();
  bounds::Strut made{-1, 1, strut.strength};
  for (const bounds::WallEdge& edge : edges) {
    if (edge.face[0] && edge.face[1]) continue;
    const bool is_left = !edge.face[0];
    for (const int node : edge.node) {
      const double off = std::abs(problem.nodes[static_cast<std::size_t>(node)][1] - strut.level);
      if (off >= least) continue;
      least = off;
      made.node = node;
      made.way = (is_left ? edge.normal[0] : -edge.normal[0]) > 0 ? 1 : -1;
    }
  }
  if (made.node < 0 || least > 1e-6 * bounds::find_units(problem).length)
    throw Error(ExitCode::wrong_input,
                fmt::format("the strut of wall '{}' at y = {} finds no free side of the wall there", wall.name,
                            format_coordinate(strut.level, unit)));
  return made;
}

void refuse_shared_edges(const bounds::Problem& problem, const ShownUnit& unit) {
  std::set<bounds::EdgeKey> keys;
  for (const bounds::Wall& wall : problem.walls)
    for (std::size_t i = 0; i < wall.size(); ++i)
      if (!keys.insert(bounds::make_key(wall.nodes[i], wall.nodes[i + 1])).second)
        throw Error(ExitCode::wrong_input,
                    fmt::format("two walls lie on each other at {}, which limit analysis does not take",
                                format_point(problem.nodes[static_cast<std::size_t>(wall.nodes[i])], unit)));
}

}  // namespace

mesh::Plan conform_to_loaded_walls(const site::Site& site, mesh::Plan plan) {
  const std::vector<WallLine> walls = list_walls(site);
  if (walls.empty()) return plan;
  std::vector<site::Point> places;
  for (const WallLine& wall : walls)
    for (const double level : site.data().supports.at(wall.support).strut_levels)
      for (const site::Point& place : find_level(wall, level)) places.push_back(place);
  for (const site::Bar& bar : site::list_bars(site)) {
    if (bar.kind == input::SupportKind::wall) continue;
    if (const auto wall = find_wall(site, walls, bar.head))
      places.push_back(find_nearest(walls[*wall].points, bar.head));
  }
  return conform_to_walls(site, std::move(plan), places);
}

void add_walls(const site::Site& site, const mesh::Mesh<2>& mesh, std::vector<int>& number, bounds::Problem& problem) {
  const std::vector<fem::Wall> walls = make_walls(site, mesh);
  for (const fem::Wall& given : walls) {
    bounds::Wall& wall = problem.walls.emplace_back();
    for (const int node : given.nodes) {
      int& own = number[static_cast<std::size_t>(node)];
      if (own < 0) {
        own = static_cast<int>(problem.nodes.size());
        problem.nodes.push_back(mesh.nodes[static_cast<std::size_t>(node)]);
      }
      wall.nodes.push_back(own);
    }
    wall.interface.resize(wall.nodes.size() - 1);
    wall.moment = given.moment, wall.axial = given.axial, wall.shear = given.shear;
    wall.line_load = given.line_load;
  }
  refuse_shared_edges(problem, site.data().units().length);
  const bool is_davis = site.data().bounds.flow == input::BoundsFlow::davis;
  const auto edges = bounds::list_wall_edges(problem);
  for (std::size_t w = 0; w < walls.size(); ++w) {
    for (std::size_t i = 0; i < edges[w].size(); ++i)
      for (const std::size_t side : {0, 1}) {
        const auto& face = edges[w][i].face[side];
        if (!face) continue;
        const auto find = [&](std::size_t end) {
          return walls[w].interface(problem.region[face->triangle],
                                    problem.nodes[static_cast<std::size_t>(edges[w][i].node[end])]);
        };
        const fem::InterfaceStrength upper = find(0), lower = find(1);
        // An interface does not dilate in FEM; Davis' strength is that of ψ = 0.
        const double share = is_davis ? 1 / std::hypot(1, upper.friction) : 1;
        const auto [least, most] = std::minmax(upper.adhesion, lower.adhesion);
        problem.walls[w].interface[i][side] = {share * least, share * upper.friction, share * (most - least)};
      }
    for (const fem::Strut& strut : walls[w].struts)
      problem.walls[w].struts.push_back(make_strut(strut, walls[w], edges[w], problem, site.data().units().length));
  }
}

}  // namespace talus::run
