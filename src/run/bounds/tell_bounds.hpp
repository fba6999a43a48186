// SPDX-License-Identifier: MIT
#pragma once
// The results of proven bounds.

#include "bounds/find_bounds.hpp"
#include "results/bounds.hpp"

namespace talus::run {

/// Bounds, meshes, fields and the lines of the mechanism; warnings where a bound is missing, or the interval is wider
/// than the gap that was asked for.
results::BoundsFile make_bounds_result(const bounds::BoundsResult& found, double asked_gap);

}  // namespace talus::run
