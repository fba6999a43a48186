// SPDX-License-Identifier: MIT
#pragma once
// Where the plants of [[roots]] draw water: the distribution β of T16.1, for the seepage solver and for the engine.

#include <vector>

#include "fem/seepage/root_sink.hpp"
#include "input/case/case.hpp"
#include "mpm/body/body.hpp"

namespace talus::ground {

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
