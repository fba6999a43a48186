// SPDX-License-Identifier: MIT
#pragma once
// A vegetated slope as a case file: Tables 4.2 and 4.3 of the source, and a hedge on Mohr–Coulomb soil.

#include "slope.hpp"

namespace talus::input {

inline const std::string rooted_slope = R"(title = "Vegetated slope under rain"

[geometry]
box = [[0, 0], [11, 6]]

[[geometry.polygon]]
name = "loess"
points = [[0, 0], [11, 0], [11, 1], [7, 1], [3, 5], [0, 5]]

[[geometry.line]]
name = "crest"
points = [[0, 5], [3, 5]]

[[geometry.line]]
name = "face"
points = [[3, 5], [7, 1]]

[mesh]
size = 0.3

[water]
bulk_modulus = 5000

[materials.loess]
model = "rooted_cam_clay"
grain_density = 2710
void_ratio = 0.6
poisson_ratio = 0.35
lambda = 0.155
kappa = 0.04
critical_state_slope = 0.827
preconsolidation_ratio = 3
suction_hardening = 10
root_hardening = 0.4
root_strength = 0.18

[materials.loess.water]
retention = "van_genuchten"
reference_pressure = 15.63
lambda = 0.288
conductivity = 7.62e-4
relative_conductivity = "mualem"

[regions]
loess = "loess"

[[boundary]]
on = "bottom"
fix = "full"

[[roots]]
ground = "face"
depth = 0.5
content = 0.94

[initial]
pore_pressure = "water_table"
water_table = [[0, 1]]
equilibrium = "gravity"

[[stage]]
name = "gravity"
duration = 10
damping = 0.75

[[stage]]
name = "rain"
duration = 560
)";

/// The same with `old_part` replaced by `new_part`, which holds the mark of the one fault that is expected.
inline void expect_root_fault(const std::string& old_part, const std::string& new_part, const std::string& part) {
  expect_fault(change(rooted_slope, old_part, new_part), part);
}

/// Adds keys to the [[roots]] of the slope.
inline std::string with_roots(const std::string& keys) {
  return change(rooted_slope, "content = 0.94\n", "content = 0.94\n" + keys);
}

/// The slope with a Mohr–Coulomb soil whose roots are `roots`.
inline std::string with_cohesion(const std::string& roots) {
  const auto from = rooted_slope.find("[materials.loess]"), to = rooted_slope.find("[materials.loess.water]");
  const std::string text = rooted_slope.substr(0, from) + R"([materials.loess]
model = "rooted_mohr_coulomb"
grain_density = 2710
porosity = 0.375
young_modulus = 10000
poisson_ratio = 0.35
cohesion = 2
friction_angle = 25
dilatancy_angle = 0
tensile_strength = 0

)" + rooted_slope.substr(to);
  return change(change(text, "content = 0.94\n", roots), "equilibrium = \"gravity\"\n", "");
}

}  // namespace talus::input
