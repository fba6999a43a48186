// SPDX-License-Identifier: MIT
#pragma once
// Unit weights of soil for slices and finite elements, with the water in its pores.

#include "input/case/case.hpp"

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

}  // namespace talus::ground
