// SPDX-License-Identifier: MIT
#pragma once
// A very coarse slope, whose whole strength reduction takes a second, with everything that a report shows.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "support/run_json.hpp"
#include "support/slopes.hpp"

namespace talus::report {

/// Elements of 3 m, two soils, a load, monitors, frames, a curve of four factors with a runout, a frozen factor.
inline const std::string small_case =
    support::write_slope(
        "dry",
        {"title=Small </script><b>slope",
         "geometry.polygon=[{ name = 'ground', points = [[0, 0], [44, 0], [44, 5], [0, 5]] }, "
         "{ name = 'slope', points = [[0, 5], [32, 5], [12, 15], [0, 15]] }]",
         "mesh.size=3",
         "materials={ clay = { model = 'mohr_coulomb', grain_density = 2650, porosity = 0.4, young_modulus = '45 MPa', "
         "poisson_ratio = 0.3, cohesion = 4, friction_angle = 30, dilatancy_angle = 0, tensile_strength = 0 }, "
         "rock = { model = 'linear_elastic', grain_density = 2650, porosity = 0.1, young_modulus = '200 MPa', "
         "poisson_ratio = 0.25 } }",
         "regions={ ground = 'rock', slope = 'clay' }"}) +
    R"(
[[traction]]
on = "crest"
traction = [0, -5]

[[stage]]
name = "gravity"
duration = 20
until = "rest"
damping = 0.75
cohesion = "200 kPa"

[[stage]]
name = "real strength"
duration = 5
damping = 0.5
reset_displacement = true

[analysis]
kind = "strength_reduction"

[strength_reduction.curve]
smoothing = "none"
from = 1.4
to = 2.0
step = 0.2
refine = false
window = 1
runout = [2.0]
runout_time = 2

[strength_reduction.frozen]
meshes = 1
resolution = 0.1

[output]
frame_interval = 0.5

[[output.monitor]]
name = "crest"
at = [12, 15]
)";

inline nlohmann::json run_small_case(const std::filesystem::path& folder,
                                     const std::vector<input::Override>& overrides = {}) {
  run::RunOptions options;
  options.folder = folder;
  options.overwrite = true;
  return support::run_case(input::read_case_text(small_case, "small.toml", overrides), options);
}

}  // namespace talus::report
