// SPDX-License-Identifier: MIT
#pragma once
// The base of a sliding mass as arcs and straight pieces, and its intersections with the lines of the section.

#include <vector>

#include "lem/section/strips.hpp"
#include "lem/surface/surface.hpp"

namespace talus::lem {

/// An arc of the circle of the surface, or a straight piece.
struct BasePiece {
  double from = 0, to = 0;  ///< [m]
  bool arc = false;
  StripLine line;        ///< of a straight piece, given by its elevation at `from`
  bool follows = false;  ///< a straight piece along the bottom of the soil or the top of impenetrable soil
};

/// A part of the base that lies in one piece, one strip and one layer.
struct Stretch {
  double from = 0, to = 0;  ///< [m]
  int piece = 0, strip = 0, layer = 0;
};

struct BaseLine {
  Circle circle;
  std::vector<BasePiece> pieces;
  std::vector<Stretch> stretches;
  std::vector<double> meets;  ///< scratch memory
  bool composite = false;

  double at(const BasePiece& piece, double x) const;
  double at(double x) const;
  /// Returns true if the piece passes a point within `tolerance`, measured normal to it because an arc may be steep.
  bool passes(const BasePiece& piece, const Point& p, double tolerance) const;
  /// Returns true if the base ends on the ground at this x, or on a vertical step of it.
  bool ends_on_ground(const Slope::Strips& strips, const BasePiece& piece, double x, double tolerance) const;
  /// Makes the pieces. With `may_cut` they continue along the bottom of the soil where they would reach below it, else
  /// such arcs are rejected. Along the top of impenetrable soil they continue in any case.
  Refusal lay(const Slope& slope, const Surface& surface, bool may_cut);
  /// Divides the base between `from` and `to` at all lines of the section; rejects a base that rises above the ground.
  Refusal divide(const Slope& slope, double from, double to);

 private:
  Refusal lay_polyline(const Slope& slope, const Surface& surface, bool may_cut);
  /// Lets the pieces follow the lines that they may not cut.
  Refusal clip(const Slope::Strips& strips, const Surface& surface, bool may_cut);
  /// Lets the pieces pass steps of these lines on ramps from their upper edges; `step`: largest height that is rounding
  /// [m].
  Refusal bridge_steps(const Surface& surface, double step);
  /// Replaces what lies below a line from the end of a piece, which falls towards larger (1) or smaller x (-1). Returns
  /// false if the line does not meet the base again.
  bool add_ramp(const Point& edge, int way, double fall);
};

/// Largest distance of the ends of a surface from the ground, over its width [-].
inline constexpr double ground_tolerance = 1e-4;

}  // namespace talus::lem
