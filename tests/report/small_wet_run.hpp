#pragma once
// A bank so coarse that it runs in a moment, with everything about pore water that a report shows: wet and dry soil,
// standing water that rises, rain in steps, runoff, a drained and a coupled stage.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "input/read.hpp"
#include "support/run_json.hpp"

namespace talus::report {

inline const std::string wet_case = R"(title = "Wet bank"

[geometry]
box = [[0, 0], [10, 4]]

[[geometry.polygon]]
name = "bank"
points = [[0, 1], [7, 1], [4, 3], [0, 3]]

[[geometry.polygon]]
name = "base"
points = [[0, 0], [10, 0], [10, 1], [0, 1]]

[[geometry.line]]
name = "crest"
points = [[0, 3], [4, 3]]

[[geometry.line]]
name = "face"
points = [[4, 3], [7, 1]]

[mesh]
size = 0.7

[water]
bulk_modulus = "80 MPa"

[materials.silt]
model = "mohr_coulomb"
grain_density = 2650
porosity = 0.4
young_modulus = "20 MPa"
poisson_ratio = 0.3
cohesion = "20 kPa"
friction_angle = 30
dilatancy_angle = 0
tensile_strength = "5 kPa"

[materials.silt.water]
retention = "van_genuchten"
minimum_saturation = 0.15
reference_pressure = "6 kPa"
lambda = 0.3
conductivity = "1e-4 m/s"
relative_conductivity = "mualem"
measure = "effective"

[materials.basalt]
model = "linear_elastic"
grain_density = 2700
porosity = 0.05
young_modulus = "100 MPa"
poisson_ratio = 0.25

[regions]
bank = "silt"
base = "basalt"

[[boundary]]
on = "bottom"
fix = "full"

[[boundary]]
on = "left"
fix = "normal"

[[boundary]]
on = "right"
fix = "normal"

[[hydraulic]]
on = "left"
condition = "total_head"
head = [[0, 2], [2, 2.5]]

[[hydraulic]]
on = "crest"
condition = "rain"
rate = [[0, "20 mm/h"], ["1 s", 3600], ["2 s", 0]]
series = "steps"

[[hydraulic]]
on = "face"
condition = "rain"
rate = "720 mm/h"

[initial]
stress = "k0"
pore_pressure = "water_table"
water_table = [[0, 2], [7, 1]]

[[stage]]
name = "weight"
duration = 10
until = "rest"
geometry = "frozen"
water = "held"
damping = 0.5

[[stage]]
name = "rain"
duration = 0.2
damping = 0.05
conductivity_factor = 10
pressure_smoothing = false
reset_displacement = true

[output]
frame_interval = 0.1

[[output.monitor]]
name = "foot"
at = [7, 1]
)";

inline nlohmann::json run_wet_case(const std::filesystem::path& folder,
                                   const std::vector<input::Override>& overrides = {}) {
  run::RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  return support::run_case(input::read_case_text(wet_case, "wet.toml", overrides), options);
}

}  // namespace talus::report
