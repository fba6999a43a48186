// SPDX-License-Identifier: MIT
#pragma once
// Where roots are: from the blocks of [[roots]] to the root content and the root cohesion of places in the soil.

#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"

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

}  // namespace talus::ground
