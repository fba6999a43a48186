// SPDX-License-Identifier: MIT
#pragma once
// Pore water of a case as the engine takes it: the laws of each soil, and the water in the pores.

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "ground/seepage_results.hpp"
#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "mpm/two_velocity/water.hpp"

namespace talus::ground {

/// Whether some soil that fills a region has pore water.
bool has_water(const input::Case& data);

/// The laws of water in each material, by material number (list_materials); empty when has_water() is false.
std::vector<mpm::WaterLaw> make_water_laws(const input::Case& data);

/// γ_w [N/m³] under the model's gravity.
double find_water_weight(const input::Case& data);

/// The material that fills element `e` at the start; nullptr where there is no soil. Throws Error (wrong_input) when
/// its region has no material.
template <int D>
const input::Material* find_soil(const input::Case& data, const mesh::Mesh<D>& mesh, int e);

/// Throws Error (wrong_input) unless gravity acts along -y, as heads and water tables are levels of y. `what` begins
/// the sentence: "a water table".
void check_upright(const input::Case& data, const char* what);

// Pore water that is held while the soil moves little: pressures at the corners of the elements and the weight of the
// soil with its water, for finite elements and for material points without a phase of water.

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
