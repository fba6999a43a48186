// SPDX-License-Identifier: MIT
#pragma once
// A wet slope that uses every part of the two-velocity step at once: unsaturated soil over a less permeable one of
// another porosity, a dry berm, ponded water at the toe, rain, a head behind the slope, and plastic failure through
// many elements.

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "reference/two_phase_bodies.hpp"

namespace talus::reference {

/// S = 0.1 + 0.9 exp(−s/15 kPa), k_r = S³: smooth but for the kink at p = 0.
Curves wet_slope_curves();

/// Soils: 0 the slope, 1 the ground below y = 1 m, 2 the dry berm on the crest. The steps of wet_slope_step() are
/// stable.
template <int D>
WetBody<D> make_wet_slope(unsigned seed = 1);

/// A stable step for make_wet_slope() [s].
template <int D>
double wet_slope_step(const WetBody<D>& body, Drag drag = Drag::implicit_at_nodes);

}  // namespace talus::reference
