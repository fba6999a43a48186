// SPDX-License-Identifier: MIT
#pragma once
// The walls of a case in FEM and limit analysis: lines of the mesh, beams with interfaces, and their forces as results.

#include <optional>
#include <string>
#include <vector>

#include "fem/solid/solid.hpp"
#include "results/elements.hpp"
#include "site/site.hpp"

namespace talus::run {

/// A wall as a polyline from its head to its toe. Points near the ground are moved onto it.
struct WallLine {
  std::string support;  ///< its name in the case
  int row = 1;
  site::Polyline points;  ///< [m]
};

/// Returns the walls of a case in the order of their names. Throws as site::list_bars() and check_walls().
std::vector<WallLine> list_walls(const site::Site& site);

/// Returns the index of the wall on which a point lies, within 1e-3 of the width of the section.
std::optional<std::size_t> find_wall(const site::Site& site, const std::vector<WallLine>& walls, const site::Point& p);

/// Returns the place of a line that is nearest to a point.
site::Point find_nearest(const site::Polyline& line, const site::Point& p);

/// Returns `plan` with the walls as lines, which also have those of `places` that lie on them as points, and their ends
/// on the ground as corners.
mesh::Plan conform_to_walls(const site::Site& site, mesh::Plan plan, const std::vector<site::Point>& places = {});

/// The same for given walls in a section of this width [m].
mesh::Plan conform_to_walls(const std::vector<WallLine>& walls, double width, mesh::Plan plan,
                            const std::vector<site::Point>& places = {});

/// Returns true if the case has walls through which no water seeps.
bool has_impermeable_walls(const input::Case& data);

/// Returns true if an interface of a wall has a strength.
bool has_rough_walls(const input::Case& data);

/// Returns `mesh` with its nodes doubled along the impermeable walls, to which it must conform. Throws as make_walls()
/// and mesh::split().
mesh::Mesh<2> cut_at_walls(const site::Site& site, mesh::Mesh<2> mesh);
inline mesh::Mesh<3> cut_at_walls(const site::Site&, mesh::Mesh<3> mesh) {
  return mesh;
}

/// Generates the mesh of the seepage of a case, cut at its impermeable walls.
template <int D>
mesh::Mesh<D> generate_for_seepage(const site::Site& site);

/// Makes the walls on a mesh that conforms to them, without the stiffness of those that have none. Throws Error
/// (wrong_input) if it does not, or if the strength of the soil does not give that of the interface.
std::vector<fem::Wall> make_walls(const site::Site& site, const mesh::Mesh<2>& mesh);
inline std::vector<fem::Wall> make_walls(const site::Site&, const mesh::Mesh<3>&) {
  return {};
}

/// Returns the forces of a wall, and the limit that it has reached. `start`: at full strength.
results::ElementBar make_wall_result(const WallLine& wall, const fem::BarForces& failed, const fem::BarForces& start);

}  // namespace talus::run
