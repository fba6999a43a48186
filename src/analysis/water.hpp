#pragma once
// Pore water of a case as the engine takes it: what each soil does with water, and what stands in the pores.

#include <vector>

#include "mesh/mesh.hpp"
#include "model/case.hpp"
#include "mpm/water.hpp"

namespace talus::analysis {

/// Whether some soil that fills a region has pore water.
bool has_water(const model::Case& data);

/// What water does in each material, by material number (list_materials); empty when has_water() is false.
std::vector<mpm::WaterLaw> make_water_laws(const model::Case& data);

/// γ_w [N/m³] under the model's gravity.
double find_water_weight(const model::Case& data);

/// The material that fills element `e` at the start; nullptr where there is no soil. Throws Error (wrong_input) when
/// its region has no material.
template <int D>
const model::Material* find_soil(const model::Case& data, const mesh::Mesh<D>& mesh, int e);

/// Throws Error (wrong_input) unless gravity acts along -y, as heads and water tables are levels of y. `what` begins
/// the sentence: "a water table".
void check_upright(const model::Case& data, const char* what);

}  // namespace talus::analysis
