// SPDX-License-Identifier: MIT
#pragma once
// Where the water stood before the first stage or trial (`WaterState` in web/src/contract/), with its fields.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/pack/pack.hpp"
#include "report/report.hpp"

namespace talus::report {

/// The states of a run in time. Of a folder of an older version, which has none, the water table alone.
std::vector<results::WaterState> find_water_states(const ResultFolder& folder);

/// "steady seepage", "1.5 days before the start".
std::string name_water_state(const results::WaterState& state, bool is_last);

/// `WaterState` of the contract, without fields.
nlohmann::json write_water_state(const results::WaterState& state, const std::string& title);

/// "3 days", "12 hours", "40 s".
std::string show_duration(double seconds);

/// `Model.water` without fields.
nlohmann::json list_water_states(const ResultFolder& folder);

/// The mesh of a file of fields as `WaterMesh` of the contract; its arrays are named after `name`. Throws Error
/// (wrong_input) where an element names a node that is not there.
nlohmann::json pack_water_mesh(const results::WaterFields& file, const std::string& name, Packer& packer);
/// The fields of a state; null where the file has none, or none that fits its mesh.
nlohmann::json pack_water_field(const results::WaterFields& file, const results::WaterState& state,
                                const std::string& name, Packer& packer);

/// Sets the fields of these states and `water_mesh` of the model, where the folder holds them. What cannot be read is
/// left out with a warning.
void add_water_fields(const ResultFolder& folder, nlohmann::json& document, Packer& packer);

}  // namespace talus::report
