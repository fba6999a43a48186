// SPDX-License-Identifier: MIT
#pragma once
// The surface of wet soil in a step: open sides, forces of outside water, and the water that passes.

#include <vector>

#include "mpm/state/body.hpp"
#include "mpm/state/step_options.hpp"

namespace talus::mpm {

/// Finds the open sides and computes the forces of outside water on them (3.11). Writes load, darcy_load, facing,
/// suction.
template <int D>
void load_surface(Body<D>& body, const StepOptions<D>& options);

/// Adds the water that the chunks of all ranks counted in a step, [chunk][surface], to the budgets.
template <int D>
void add_budgets(Body<D>& body, std::vector<SurfaceBudget>& by_chunk);

}  // namespace talus::mpm
