// SPDX-License-Identifier: MIT
#pragma once
// The surface of wet soil in a step: open sides, forces of outside water, and the water that passes.

#include <vector>

#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Finds the open sides and computes the forces of outside water on them (3.11). Writes load, darcy_load, facing,
/// suction.
template <int D>
void load_surface(Body<D>& body, const StepOptions<D>& options);

/// Adds the water that the chunks of all ranks counted in a step, [chunk][surface], to the budgets.
template <int D>
void add_budgets(Body<D>& body, std::vector<SurfaceBudget>& by_chunk);

// Uptake of pore water by plant roots (docs/theory/16-season.md).

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
