// SPDX-License-Identifier: MIT
#pragma once
// Finer triangles where they are asked for: nested, so that bounds can only tighten.

#include "bounds/problem.hpp"

namespace talus::bounds {

/// Halves the longest edge of each marked triangle and of those that must follow (Rivara, Int. J. Numer. Meth. Eng. 20,
/// 1984). Nodes, triangles, regions and sides are replaced; strength, forces and pressures of a triangle are those of
/// its parent, linear as there.
Problem refine(const Problem& problem, const std::vector<bool>& marked);

/// Nodes of the border at which stress may jump: it turns, or its load or its support changes.
std::vector<int> find_corners(const Problem& problem);

/// Triangles around these nodes no wider than so many radians: a stress that turns around a point needs a fan of them.
Problem fan_out(const Problem& problem, const std::vector<int>& nodes, double widest);

}  // namespace talus::bounds
