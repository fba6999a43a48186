// SPDX-License-Identifier: MIT
#pragma once
// Pore water that is held while the soil moves little: pressures at the corners of the elements and the weight of the
// soil with its water, for finite elements and for material points without a phase of water.

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "ground/tell_seepage.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"

namespace talus::ground {

/// By element; zero in empty ones.
template <int D>
struct HeldWater {
  std::vector<double> unit_weight;              ///< of the soil with its water [N/m³]
  std::vector<std::array<double, D + 1>> pore;  ///< χp at the corners, positive in tension [Pa]; 0 in total stresses
  bool acts = false;                            ///< some pressure is not 0
};

/// From the water table or the seepage of the case, and from r_u. `told` as in find_nodal_pressure().
template <int D>
HeldWater<D> find_held_water(const input::Case& data, const mesh::Mesh<D>& mesh, WaterResult* summary = nullptr);

/// The part of it that follows from r_u alone, over soil of these unit weights [N/m³]. False: no soil has one.
template <int D>
bool add_pressure_ratio(const input::Case& data, const mesh::Mesh<D>& mesh, const std::vector<double>& unit_weight,
                        std::vector<std::array<double, D + 1>>& pore);

/// Acceleration that a pseudo-static earthquake adds to that of gravity, in g, in its direction. Where the case gives
/// none: towards the lower end of the ground, and towards larger x where `ground` is empty or both ends equally high.
template <int D>
Vec<D> find_earthquake(const input::Case& data, const std::vector<std::array<double, 2>>& ground);

}  // namespace talus::ground
