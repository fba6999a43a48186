// SPDX-License-Identifier: MIT
#pragma once
// A very coarse bank with everything on pore water that a report shows: wet and dry soil, rising ponded water, rain in
// steps, runoff, a drained stage and one with two velocities.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "support/run_json.hpp"
#include "support/slopes.hpp"

namespace talus::report {

inline const std::string wet_case = support::write_slope(
    "wet_bank",
    {"geometry.polygon=[{ name = 'bank', points = [[0, 1], [7, 1], [4, 3], [0, 3]] }, "
     "{ name = 'base', points = [[0, 0], [10, 0], [10, 1], [0, 1]] }]",
     "geometry.line=[{ name = 'crest', points = [[0, 3], [4, 3]] }, { name = 'face', points = [[4, 3], [7, 1]] }]",
     "mesh.size=0.7", "materials.silt.water.conductivity=1e-4", "materials.silt.water.relative_conductivity=mualem",
     "materials.silt.water.measure=effective",
     "materials.basalt={ model = 'linear_elastic', grain_density = 2700, porosity = 0.05, young_modulus = '100 MPa', "
     "poisson_ratio = 0.25 }",
     "regions={ bank = 'silt', base = 'basalt' }",
     "hydraulic=[{ on = 'left', condition = 'total_head', head = [[0, 2], [2, 2.5]] }, "
     "{ on = 'crest', condition = 'rain', rate = [[0, '20 mm/h'], ['1 s', 3600], ['2 s', 0]], series = 'steps' }, "
     "{ on = 'face', condition = 'rain', rate = '720 mm/h' }]",
     "initial.pore_pressure=water_table", "initial.water_table=[[0, 2], [7, 1]]",
     "stage.1={ name = 'rain', duration = 0.2, damping = 0.05, conductivity_factor = 10, pressure_smoothing = false, "
     "reset_displacement = true }",
     "output.monitor.toe.name=foot"});

inline nlohmann::json run_wet_case(const std::filesystem::path& folder,
                                   const std::vector<input::Override>& overrides = {}) {
  run::RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  return support::run_case(input::read_case_text(wet_case, "wet.toml", overrides), options);
}

}  // namespace talus::report
