// SPDX-License-Identifier: MIT
#pragma once
// Roots by the blocks of [[roots]]: root content, root cohesion and the distribution of water uptake.

#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "fem/seepage/hydraulic_boundary.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"

namespace talus::site {

/// Returns the depths of points normal to the ground [m]: the shortest distance from the named line, in 3D from the
/// surface. Throws Error (wrong_input) if the mesh has no such line.
template <int D>
std::vector<double> find_depths(const mesh::Mesh<D>& mesh, const std::string& ground,
                                const std::vector<Vec<D>>& places);

/// Returns the roots at a depth and at a place along the ground as a fraction of those at the ground [-] (T17.5): 1
/// where the block gives its content, 0 below its depth. `x`: horizontal coordinate of the place [m].
double find_root_share(const input::Roots& roots, double depth, double x);

/// Returns the fraction of the roots by age and felling, growth × decay [-].
double find_age_share(const input::Roots& roots);

/// Returns c_r at the ground of fully grown roots, given or computed from their bundle [Pa]; nothing if the block has
/// neither.
std::optional<double> find_ground_cohesion(const input::Roots& roots);

/// Roots at a point.
struct RootsAt {
  double content = 0;   ///< m_r [%]
  double cohesion = 0;  ///< c_r [Pa]
};

/// Returns content or cohesion, whichever the law of the soil uses; zero for other laws. The blocks whose depth
/// includes a point are summed; where there is none, the material's own value applies. `soils`: the material at each
/// point.
template <int D>
std::vector<RootsAt> find_roots(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<Vec<D>>& places,
                                const std::vector<const input::Material*>& soils);

/// Returns the input of find_roots() for a case as text: equal texts mean equal roots on the same mesh.
std::string write_root_input(const input::Case& data);

// Distribution β of the water uptake of [[roots]] (T16.1), for the seepage solver and for MPM.

/// Ground area that transpires through each part of the wet soil.
template <int D>
struct RootDistribution {
  double covered = 0;                              ///< area A = ∫a cosθ dΓ of ground under plants [m²] (2D: m)
  std::vector<std::array<double, D + 1>> weights;  ///< ∫ β N dV per element and node; the sum is `covered`
};

/// Returns the distribution of a block. Throws Error (wrong_input) if the mesh has no line `roots.ground`, or no wet
/// soil lies within the depth of the roots.
template <int D>
RootDistribution<D> find_root_distribution(const input::Case& data, const input::Roots& roots,
                                           const mesh::Mesh<D>& mesh);

/// Returns the potential rate T(t), with steps as jumps.
input::TimeTable make_transpiration_rate(const input::Transpiration& transpiration);

/// Returns Feddes' reduction of the uptake with suction. Throws Error (wrong_input) for suctions that do not increase.
material::Feddes make_uptake_reduction(const input::Roots& roots, const ShownUnit& stress);

/// Returns one sink for each block of [[roots]] with transpiration.
template <int D>
std::vector<fem::RootSink> make_root_sinks(const input::Case& data, const mesh::Mesh<D>& mesh);

}  // namespace talus::site
