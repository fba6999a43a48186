// SPDX-License-Identifier: MIT
#pragma once
// The unsaturated slope of chapter 3 of the source as a case file, Table 3.4.

#include "slope.hpp"

namespace talus::input {

inline const std::string wet_slope = change(change(support::write_slope("dry"), "cohesion = 2", "cohesion = 10"),
                                            "friction_angle = \"30 deg\"", "friction_angle = 20") +
                                     R"(
[[geometry.line]]
name = "slope"
points = [[12, 15], [32, 5]]

[[geometry.line]]
name = "toe"
points = [[32, 5], [44, 5]]

[[geometry.line]]
name = "drain"
points = [[10, 2], [20, 2]]

[water]
bulk_modulus = 80000
viscosity = "1e-6 kPa.s"

[materials.sand.water]
retention = "van_genuchten"
minimum_saturation = 0.15
reference_pressure = 6.13
lambda = 0.27
permeability = 6e-11

[[hydraulic]]
on = "left"
condition = "total_head"
head = 10

[[hydraulic]]
on = "crest"
condition = "seepage_face"

[[hydraulic]]
on = "slope"
condition = "seepage_face"

[[hydraulic]]
on = "toe"
condition = "total_head"
head = 5

[initial]
pore_pressure = "seepage"

[[stage]]
name = "gravity"
duration = 10
damping = 0.7
conductivity_factor = 2

[analysis]
kind = "strength_reduction"
)";

/// Expects one fault of the wet slope with `old_part` replaced by `new_part`, which holds the mark.
inline void expect_wet_fault(const std::string& old_part, const std::string& new_part, const std::string& part) {
  expect_fault(change(wet_slope, old_part, new_part), part);
}

}  // namespace talus::input
