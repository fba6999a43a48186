// SPDX-License-Identifier: MIT
#pragma once
// Unit weights of soil with its pore water for LEM and FEM, suction stress, and the weight of pools.

#include <functional>
#include <vector>

#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "site/site.hpp"

namespace talus::site {

/// Returns γ [N/m³] at a pore pressure `p`, positive in tension [Pa]: the given one above or below the water table, or
/// that of the grains and the water retained at that suction.
double find_unit_weight(const input::Case& data, const input::Material& soil, double p);

/// Returns γ below the water table [N/m³].
double find_saturated_weight(const input::Case& data, const input::Material& soil);

/// Returns χ s of Bishop's effective stress at a suction s >= 0 [Pa]: χ = S_w, or after Khalili and Khabbaz; s if the
/// pores stay saturated, 0 if the soil has no retention curve or its suction is to be ignored. By φ_b, χ = tan φ_b /
/// tan φ, which adds s tan φ_b to the strength (Fredlund et al. 1978).
double find_suction_stress(const input::Material& soil, double suction);

/// Returns true if suction adds to the strength through χ.
bool uses_saturation(const input::Material& soil);

// The weight of pools on the soil below, for seepage in soil that it compresses.

/// Returns the weight of the pools over each node of `mesh` as a function of time [Pa]: that of the water above the
/// ground on the vertical of the node; at time 0 the pools are those just before it. Throws as Site::ground().
std::function<std::vector<double>(double time)> make_pool_weight(const Site& site, const mesh::Mesh<2>& mesh);

}  // namespace talus::site
