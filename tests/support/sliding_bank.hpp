// SPDX-License-Identifier: MIT
#pragma once
// A very coarse bank, which slides within a second of computing time: three monitors, a vertical section, frames.

#include "support/slopes.hpp"

namespace talus {

/// 45° bank of 4 m, elements of 1 m; weight first, then its real strength, which does not hold it.
inline const std::string sliding_bank = support::write_slope("bank") + R"(
[[stage]]
name = "weight"
duration = 5
until = "rest"
damping = 0.75
cohesion = "200 kPa"

[[stage]]
name = "slide"
duration = 1.5
damping = 0.05
reset_displacement = true

[output]
frame_interval = 0.25
history_interval = 0.01
onset_displacement = "5 cm"

[[output.monitor]]
name = "crest"
at = [3, 5]

[[output.monitor]]
name = "toe"
at = [6.5, 1.2]

[[output.section]]
name = "A"
from = [2, 0]
to = [2, 5]
width = 1
)";

/// The same with one more friction angle, which holds it better.
inline const std::string sliding_banks = sliding_bank + R"(
[study]
reference = "friction_angle = 15 deg"

[[study.vary]]
key = "materials.silt.friction_angle"
values = ["15 deg", "25 deg"]
)";

}  // namespace talus
