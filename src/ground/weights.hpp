// SPDX-License-Identifier: MIT
#pragma once
// Unit weights of soil for slices and finite elements, with the water in its pores.

#include <functional>
#include <vector>

#include "input/case/case.hpp"
#include "mesh/mesh.hpp"

namespace talus::ground {

/// γ [N/m³] at a pore pressure `p` positive in tension [Pa]: as given above and below the water table, or of grains and
/// the water that the pores hold at that suction.
double find_unit_weight(const input::Case& data, const input::Material& soil, double p);

/// Below the water table.
double find_saturated_weight(const input::Case& data, const input::Material& soil);

/// χ s of Bishop's effective stress at a suction s >= 0 [Pa]: χ = S_w or that of Khalili and Khabbaz; s itself where
/// the pores stay full, 0 where the soil has no retention curve or is asked to leave suction out.
double find_suction_stress(const input::Material& soil, double suction);

/// Whether suction adds to the strength through χ.
bool uses_saturation(const input::Material& soil);

// The weight of pools on the soil under them, for seepage in soil that is compressed by it.

/// Weight of the pools over each node of `mesh` as a function of time [Pa]: that of the water over the ground of its
/// vertical; at time 0 those just before it. The function keeps `data`. Throws what find_ground() throws.
std::function<std::vector<double>(double time)> make_pool_weight(const input::Case& data, const mesh::Mesh<2>& mesh);

}  // namespace talus::ground
