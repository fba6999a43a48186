// SPDX-License-Identifier: MIT
#pragma once
// Pore water of a case as the engine takes it: the laws of each soil, and the water in the pores.

#include <vector>

#include "input/case/case.hpp"
#include "mesh/mesh.hpp"
#include "mpm/coupled/water.hpp"

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

}  // namespace talus::ground
