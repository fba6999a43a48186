// SPDX-License-Identifier: MIT
#pragma once
// Uptake of pore water by plant roots (docs/theory/16-season.md).

#include "mpm/state/body.hpp"
#include "mpm/state/step_options.hpp"

namespace talus::mpm {

/// Number of steps between exchanges of water, and between root uptakes.
inline constexpr int exchange_interval = 4;

/// Adds the root uptake until the next call to the water's surplus, which the next pass removes from the points, and to
/// Water::transpired. Does nothing while the geometry is frozen.
template <int D>
void draw_root_water(Body<D>& body, const StepOptions<D>& options);

/// The same for the Darcy step, in every step: writes water.darcy.drawn [m³] and adds to Water::transpired.
template <int D>
void find_root_draw(Body<D>& body, const StepOptions<D>& options);

}  // namespace talus::mpm
