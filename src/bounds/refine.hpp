// SPDX-License-Identifier: MIT
#pragma once
// Refinement of marked triangles into nested meshes, on which the bounds can only become tighter.

#include "bounds/problem.hpp"

namespace talus::bounds {

/// Bisects the longest edge of each marked triangle and of those that conformity requires (Rivara, Int. J. Numer. Meth.
/// Eng. 20, 1984). Nodes, triangles, regions and sides are replaced; strength, forces and pressures are interpolated
/// from the parent triangle.
Problem refine(const Problem& problem, const std::vector<bool>& marked);

/// Returns the nodes of the border at which stress may jump: at a corner, or where the load or the support changes.
std::vector<int> find_corners(const Problem& problem);

/// Divides the triangles around these nodes until their angle there is at most `widest` [rad], as a stress field whose
/// principal directions rotate around a point needs a fan.
Problem fan_out(const Problem& problem, const std::vector<int>& nodes, double widest);

/// Marks the fewest triangles with four fifths of the sum of `parts`, the contributions to the gap, but at least the
/// fraction `fewest` of all, and at most the fraction `most`.
std::vector<bool> mark(const std::vector<double>& parts, double fewest, double most);

/// Marks the triangles of a refined problem whose centre lies in a marked triangle of the one before.
std::vector<bool> mark_inside(const Problem& before, const std::vector<bool>& marked, const Problem& finer);

}  // namespace talus::bounds
