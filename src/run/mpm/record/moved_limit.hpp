// SPDX-License-Identifier: MIT
#pragma once
// The slip line of material points: the lower limit of the soil that moved.

#include <array>
#include <vector>

#include "mpm/body/body.hpp"

namespace talus::run {

/// Share of the largest displacement that soil of a slide has moved at least [-].
inline constexpr double moved_share = 0.25;

/// The lower limit of the soil that moved by more than `threshold` [m], from left to right: for each column the height
/// that separates best the moved soil from the rest, with the fewest points on the wrong side; the longest stretch of
/// such columns, smoothed. Empty where fewer than six stand side by side. `positions` before the motion [m], `spacing`:
/// mean distance of the points [m].
std::vector<std::array<double, 2>> find_moved_limit(const std::vector<std::array<double, 2>>& positions,
                                                    const std::vector<double>& displacement, double spacing,
                                                    double threshold);

/// The same of a body at frozen geometry, whose points have not moved in space; soil that moved by moved_share of the
/// largest displacement.
std::vector<std::array<double, 2>> find_frozen_limit(const mpm::Body<2>& body);

}  // namespace talus::run
