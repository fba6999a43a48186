// SPDX-License-Identifier: MIT
#pragma once
// Pore water of a frame as an engineer asks for it, from what the results hold.

#include "output/files/frame.hpp"

namespace talus::report {

/// Replaces the water's own velocity w by Darcy's, nS(w - v): volume per time and area of soil [m/s]. Points of dry
/// soil, whose saturation is zero, get no pressure, saturation or flow. A dry frame stays as it is.
void show_water(output::Frame& frame);

}  // namespace talus::report
