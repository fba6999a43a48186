// SPDX-License-Identifier: MIT
#pragma once
// Local optimisation of a surface of any shape: the vertices of a polyline.

#include "lem/search/optimise_circle.hpp"

namespace talus::lem {

struct SurfaceRanges {
  std::array<double, 2> left{}, right{};  ///< where the ends may go [m]
  int vertices = 12;                      ///< the ends included
};

/// Lowest and highest elevation of a polygon at x; none beside it.
std::optional<std::array<double, 2>> find_borders(const std::vector<Point>& polygon, double x);

/// The polyline with `vertices` vertices through a circle (or composite circle), lying below the ground.
Surface make_polyline(const Slope& slope, const Surface& surface, int vertices);

/// The same surface, but nowhere below the upper or lower border of a region: the starts for weak seams.
std::vector<Surface> make_seam_starts(const Slope& slope, const Surface& surface, int vertices);

/// Never worse than `start`. Surfaces stay kinematically admissible: no steeper towards the toe, under the ground,
/// above the base. Begins with few vertices and inserts more, and gives up where `to_beat` is out of reach.
OptimisedSurface optimise_polyline(Evaluator& evaluate, const Surface& start, const SurfaceRanges& ranges,
                                   double to_beat = Evaluator::refused);

}  // namespace talus::lem
