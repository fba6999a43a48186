// SPDX-License-Identifier: MIT
#pragma once
// Loads on the ground for FEM and limit analysis (surcharges, standing water, tractions on named sides), and meshes
// that conform to them.

#include <vector>

#include "fem/solid/solid.hpp"
#include "input/case/case.hpp"
#include "mesh/plan.hpp"
#include "site/site.hpp"

namespace talus::site {

/// A side of the soil that faces upwards and has no soil behind it.
template <int D>
struct GroundSide {
  std::array<int, D> nodes{};
  Vec<D> normal{};  ///< unit, out of the soil
};
template <int D>
std::vector<GroundSide<D>> find_ground_sides(const mesh::Mesh<D>& mesh);

/// Loads that a method takes from the site beside the surcharges.
struct ActingLoads {
  bool standing_water = true;  ///< ponds and the water table above the ground
  bool hydraulics = true;      ///< heads and pressures of [[hydraulic]]; false: the method applies them itself
  bool tractions = true;       ///< on named sides
};

/// Throws Error (wrong_input), with the place, if water stands on a mesh without ground (a ready one, or one with
/// overhangs), where its weight would be missing. Has no effect on a site with ground.
template <int D>
void check_standing_water(const Site& site, const mesh::Mesh<D>& mesh, const ActingLoads& acting = {});

/// Returns the loads on the ground and on named sides as tractions linear on each side, with the force and the moment
/// of the load. In 3D the loads are those of the section that is extruded. Throws as check_standing_water().
template <int D>
std::vector<fem::SurfaceLoad<D>> make_surface_loads(const Site& site, const mesh::Mesh<D>& mesh,
                                                    const ActingLoads& acting = {});

// A plan whose mesh has nodes wherever a load on the ground begins, ends or changes its gradient.

/// Returns true if water, surcharges or an earthquake act, which are found from the ground of a section, plane or
/// extruded. Without them FEM and limit analysis need no ground, so that the section may have overhangs and cavities.
bool needs_ground(const Site& site);

/// Returns `plan` with additional corners in its polygons: on the ground at the ends and breaks of surcharges, at the
/// ends of ponds, under the vertices of a water table above the ground, and where that table meets the ground. A
/// traction linear on each side of the mesh then equals the load. A ready mesh and a plan in 3D are returned unchanged.
/// Throws as Site::ground().
mesh::Plan conform_to_loads(const Site& site, mesh::Plan plan);

/// Returns `plan` with those of `places` that lie on an outline as corners of its polygons; those within `tolerance`
/// [m] of a corner are left out.
mesh::Plan add_corners(mesh::Plan plan, const std::vector<Point>& places, double tolerance);

}  // namespace talus::site
