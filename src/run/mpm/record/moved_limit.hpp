// SPDX-License-Identifier: MIT
#pragma once
// The slip line of material points: the lower limit of the soil that moved.

#include <array>
#include <vector>

#include "mpm/body/body.hpp"
#include "results/side_line.hpp"

namespace talus::run {

/// Share of the largest displacement that soil of a slide has moved at least [-].
inline constexpr double moved_share = 0.25;

/// A section as its points lay before the motion, and how far they moved.
struct MovedSection {
  std::vector<std::array<double, 2>> positions;  ///< [m]
  std::vector<double> displacement;              ///< its length [m]
  std::vector<double> across;                    ///< its part towards larger x [m]
  double spacing = 0;                            ///< mean distance of the points [m]
};

/// The lower limit of the soil that moved.
struct MovedLimit {
  std::vector<std::array<double, 2>>
      line;                              ///< from left to right [m]; empty: none. Of two sides the one with more soil
  std::vector<results::SideLine> sides;  ///< to smaller and to larger x; empty: the soil moves one way
};

/// The lower limit of the soil that moved by more than `threshold` [m], from left to right: for each column the height
/// that separates best the moved soil from the rest, with the fewest points on the wrong side; the longest stretch of
/// such columns, smoothed. Empty where fewer than six stand side by side. Where the soil moves to both sides
/// (find_divide()), each has a limit of its own. Of sides that move apart it goes on from the divide to the ground, as
/// steep as an active wedge.
MovedLimit find_moved_limit(const MovedSection& section, double threshold);

/// The same of a body at frozen geometry, whose points have not moved in space; soil that moved by moved_share of the
/// largest displacement.
MovedLimit find_frozen_limit(const mpm::Body<2>& body);

}  // namespace talus::run
