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
  std::string name;              ///< of a surface given by the user; else empty
  std::optional<Circle> circle;  ///< lower arc from `from` to `to`; along the bottom of the soil below it (composite)
  std::vector<Point> line;       ///< vertices of a polyline from left to right, both ends on the ground
  double from = 0, to = 0;       ///< x of the two ends of an arc [m]
  double crack = 0;              ///< depth of a dry tension crack of its own [m]; 0: that of the section, if any
};

/// Reason for which a surface has no factor; the search counts them.
enum class Refusal {
  none,
  outside,        ///< does not enter and leave the ground inside the model
  too_shallow,    ///< its depth is below the smallest depth
  below_base,     ///< reaches below the base and may not
  no_driving,     ///< the driving moment or force is not positive
  m_alpha,        ///< m_α too small at the passive end: the normal force is unreliable
  tension,        ///< effective normal forces are tensile over too great a part of the base
  thrust,         ///< line of thrust outside the sliding mass
  not_converged,  ///< the equations have no solution in the range of λ and F
  steep_toe,      ///< passive end steeper than the limit, e.g. 45° - φ/2
  lambda,         ///< λ beyond its limits
  kinks,          ///< the factor of a polyline is below the wedge mechanism of its base: its kinks would slide without
                  ///< strength
  moment_axis,    ///< a method of moments about the centre of a circle, on a surface that is not circular
  chart,          ///< outside the range of the chart of Janbu's correction
  held,           ///< soil that is not reduced holds the mass at any factor
  too_small,      ///< area or weight of the mass below the smallest
  excluded,       ///< enters an excluded area
  passage,        ///< misses a window that every surface passes
  direction,      ///< slides to the other side than asked for
  blocked,        ///< meets a step of the base that it cannot pass
  count
};

/// Returns the text of a reason for messages.
const char* name_refusal(Refusal refusal);

class Slope;

/// Returns the faults of a surface given by the user, each as a sentence that names it: ends that are not on the
/// ground, a polyline that runs backwards, parts above the ground or below the base.
std::vector<std::string> find_faults(const Slope& slope, const Surface& surface);

/// Returns the parts of the lower arc of a circle that lie below the ground, each from ground to ground: x of the two
/// ends, from left to right.
std::vector<std::array<double, 2>> find_arcs(const Slope& slope, const Circle& circle);

// Admissible polyline surfaces.

/// Returns the surface from `left` to `right` on the ground that is the lower convex hull of all points and of all
/// corners of the ground between them. A block on it need not bend upwards to slide, so that every such surface is
/// kinematically admissible; it changes continuously with the points.
Surface hang_polyline(const Slope& slope, double left, double right, const std::vector<Point>& points);

/// Returns `count` of the points of a hull, including its ends: the vertices whose removal changes it least are dropped
/// first.
std::vector<Point> thin_points(std::vector<Point> line, int count);

/// Returns a polyline without the points on the straight lines between their neighbours. It may bend to both sides.
std::vector<Point> drop_straight_points(const std::vector<Point>& line);

}  // namespace talus::lem
