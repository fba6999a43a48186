// SPDX-License-Identifier: MIT
#pragma once
// A slip surface: an arc or a polyline from ground to ground.

#include <optional>
#include <string>
#include <vector>

#include "lem/section/section.hpp"
#include "lem/section/slope.hpp"

namespace talus::lem {

struct Circle {
  Point centre{};     ///< [m]
  double radius = 0;  ///< [m]
};

struct Surface {
  std::string name;              ///< of a surface that the user gave; else empty
  std::optional<Circle> circle;  ///< the lower arc between `from` and `to`; cut level at the section's base (composite)
  std::vector<Point> line;       ///< of a polyline surface: from left to right, both ends on the ground
  double from = 0, to = 0;       ///< x of the two ends of an arc [m]
  double crack = 0;              ///< depth of a dry tension crack of its own [m]; 0: that of the section, if any
};

/// Why a surface gives no factor. Counted by the search.
enum class Refusal {
  none,
  outside,        ///< does not enter and leave the ground inside the model
  too_shallow,    ///< less deep than the smallest depth
  below_base,     ///< goes below the base, where surfaces may not
  no_driving,     ///< nothing drives it: driving moment or force is not positive
  m_alpha,        ///< m_α too small at the passive end: the normal force is unreliable
  tension,        ///< effective normal forces are tensile over too long a part
  thrust,         ///< line of thrust outside the sliding mass
  not_converged,  ///< the equations have no solution in the range of λ and F
  steep_toe,      ///< passive end steeper than the limit, e.g. 45° - φ/2
  lambda,         ///< λ beyond its limits
  kinks,          ///< a polyline below the wedge mechanism of its own base: its kinks would slide without strength
  moment_axis,    ///< a method of moments about a circle's centre, on a surface that is none
  chart,          ///< Janbu's correction outside the chart that it was fitted to
  count
};

/// Name of a refusal for people.
const char* name_refusal(Refusal refusal);

class Slope;

/// Faults of a surface that the user gave, each a sentence that names it: ends that are not on the ground, a polyline
/// that runs backwards, parts above the ground or below the base.
std::vector<std::string> find_faults(const Slope& slope, const Surface& surface);

/// The stretches of a circle's lower arc that lie below the ground, each from ground to ground: x of the two ends, from
/// left to right.
std::vector<std::array<double, 2>> find_arcs(const Slope& slope, const Circle& circle);

// Shapes of admissible polyline surfaces.

/// The surface from `left` to `right` on the ground that hangs below all points and all corners of the ground between
/// them, like a string pulled tight from below: the lower convex hull. A block that slides on it never has to bend
/// upwards, so every such surface is kinematically admissible, and it changes continuously with the points.
Surface hang_polyline(const Slope& slope, double left, double right, const std::vector<Point>& points);

/// `count` of the points of a hull, ends kept, that follow it best: the vertices whose loss changes it least go first.
std::vector<Point> thin_points(std::vector<Point> line, int count);

}  // namespace talus::lem
