// SPDX-License-Identifier: MIT
#pragma once
// States of the pore water up to the initial state of the methods (`WaterShown` in web/src/contract/): titles and
// fields.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/folder/result_folder.hpp"
#include "report/pack/pack.hpp"

namespace talus::report {

/// Returns the states of a run in order of time. Without a run, as in a study by LEM alone, it is the water table of
/// the case.
std::vector<results::WaterState> find_water_states(const ResultFolder& folder);

/// Returns a title such as "steady seepage" or "1.5 days before the start".
std::string name_water_state(const results::WaterState& state, bool is_last);

/// Returns a duration such as "3 days", "12 hours" or "40 s".
std::string show_duration(double seconds);

/// Returns `Model.water` without fields.
nlohmann::json list_water_states(const ResultFolder& folder);

/// Packs the mesh of a file of fields as `WaterMesh` of the contract; `name` is the prefix of its arrays. Throws Error
/// (wrong_input) for an invalid node number.
nlohmann::json pack_water_mesh(const results::WaterFields& file, const std::string& name, Packer& packer);
/// Packs the fields of a state; returns null if the file has none, or none that match its mesh.
nlohmann::json pack_water_field(const results::WaterFields& file, const results::WaterState& state,
                                const std::string& name, Packer& packer);

/// Adds the fields of the states and `water_mesh` to the model if the folder contains them. Files that cannot be read
/// are omitted with a warning.
void add_water_fields(const ResultFolder& folder, nlohmann::json& document, Packer& packer);

}  // namespace talus::report
