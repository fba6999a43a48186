// SPDX-License-Identifier: MIT
#pragma once
// The base of a sliding mass as arcs and straight pieces, and where it meets the lines of the section.

#include <vector>

#include "lem/slices/solve.hpp"
#include "lem/slices/strips.hpp"

namespace talus::lem {

/// An arc of the surface's circle, or a straight piece.
struct BasePiece {
  double from = 0, to = 0;  ///< [m]
  bool arc = false;
  StripLine line;  ///< of a straight piece, by its elevation at `from`
};

/// A stretch of the base in one piece, one strip and one layer.
struct Stretch {
  double from = 0, to = 0;  ///< [m]
  int piece = 0, strip = 0, layer = 0;
};

struct BaseLine {
  Circle circle;
  std::vector<BasePiece> pieces;
  std::vector<Stretch> stretches;
  std::vector<double> meets;  ///< scratch
  bool composite = false;

  double at(const BasePiece& piece, double x) const;
  double at(double x) const;
  /// Whether the piece passes a point so near. Beside the steep end of an arc its distance counts, not its height.
  bool passes(const BasePiece& piece, const Point& p, double tolerance) const;
  /// Whether the base ends on the ground at this x, or on a vertical step of it.
  bool ends_on_ground(const Slope::Strips& strips, const BasePiece& piece, double x, double tolerance) const;
  /// Lays the pieces; arcs that reach below the base are cut level there.
  Refusal lay(const Slope& slope, const Surface& surface, const Checks& checks);
  /// Cuts the base between `from` and `to` at all lines of the section; refuses a base that rises above the ground.
  Refusal divide(const Slope& slope, double from, double to);
};

/// How far over the distance of its ends a surface may miss the ground.
inline constexpr double ground_tolerance = 1e-4;

}  // namespace talus::lem
