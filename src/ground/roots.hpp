// SPDX-License-Identifier: MIT
#pragma once
// Where roots are: from the blocks of [[roots]] to the root content and the root cohesion of places in the soil.

#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "fem/seepage/hydraulic_boundary.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "mpm/body/body.hpp"

namespace talus::ground {

/// Depth of places normal to the ground: the shortest distance from the named line, in 3D from the surface that it
/// stands for [m]. Throws Error (wrong_input) when the mesh has no such line.
template <int D>
std::vector<double> find_depths(const mesh::Mesh<D>& mesh, const std::string& ground,
                                const std::vector<Vec<D>>& places);

/// Roots at a depth and at a place along the ground, as a share of those at the ground [-] (T17.5): 1 where the block
/// gives its content, 0 below its depth. `x`: horizontal coordinate of the place [m].
double find_root_share(const input::Roots& roots, double depth, double x);

/// Share of the roots by age and felling, growth × decay [-].
double find_age_share(const input::Roots& roots);

/// c_r at the ground of roots of full age, given or from their bundle [Pa]; none when the block says nothing of it.
std::optional<double> find_ground_cohesion(const input::Roots& roots);

/// Roots at a place.
struct RootsAt {
  double content = 0;   ///< m_r [%]
  double cohesion = 0;  ///< c_r [Pa]
};

/// Content or cohesion, as the soil's law takes roots; none in others. The blocks whose
/// depth reaches a place add up; where none does, the material's own value holds. `soils`: the material of each place.
template <int D>
std::vector<RootsAt> find_roots(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<Vec<D>>& places,
                                const std::vector<const input::Material*>& soils);

/// The result of find_roots() for a case, as text: equal texts mean equal roots on the same mesh.
std::string write_root_input(const input::Case& data);

// Where the plants of [[roots]] draw water: the distribution β of T16.1, for the seepage solver and for the engine.

/// The ground area that transpires through each part of the wet soil.
template <int D>
struct RootDistribution {
  double covered =
      0;  ///< ground under plants, measured on the horizontal, weighted with the share along it [m²] (2D: m)
  std::vector<std::array<double, D + 1>> weights;  ///< ∫ β N dV by element and its nodes, together `covered`
};

/// Throws Error (wrong_input) when the mesh has no line `roots.ground`, or no wet soil lies within the roots' depth.
template <int D>
RootDistribution<D> find_root_distribution(const input::Case& data, const input::Roots& roots,
                                           const mesh::Mesh<D>& mesh);

/// The potential rate, steps written out as jumps.
input::TimeTable make_transpiration_rate(const input::Transpiration& transpiration);

/// One sink for each block of [[roots]] that transpires.
template <int D>
std::vector<fem::RootSink> make_root_sinks(const input::Case& data, const mesh::Mesh<D>& mesh);

/// The same for the points of a body on the mesh as it was filled.
template <int D>
void resolve_root_uptakes(mpm::Body<D>& body, const input::Case& data);

}  // namespace talus::ground
