// SPDX-License-Identifier: MIT
#pragma once
// The results of proven bounds.

#include "bounds/find_bounds.hpp"
#include "results/bounds.hpp"

namespace talus::run {

/// Bounds, meshes, fields and the lines of the mechanism.
results::BoundsFile tell_bounds(const bounds::BoundsResult& found);

}  // namespace talus::run
