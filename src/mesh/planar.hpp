// SPDX-License-Identifier: MIT
#pragma once
// Plane geometry of polygons and polylines, with one tolerance for all that coincides.

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/plan.hpp"

namespace talus::mesh {

using Point2 = std::array<double, 2>;
using Polyline = std::vector<Point2>;

/// Distance of `x` from the segment a-b [m]; a point when a = b.
double compute_distance(const Point2& x, const Point2& a, const Point2& b);

/// Distance of `x` from a polyline, or from a point when it has only one [m].
double compute_distance(const Point2& x, const Polyline& line);

/// The closed polygon's outline as a polyline that returns to its first point.
Polyline close_polygon(const Polyline& corners);

/// The line, or the closed polygon from its leftmost corner on, without points that lie within `tolerance` [m] of the
/// straight lines between the others: its corners.
Polyline drop_straight_points(const Polyline& line, bool closed, double tolerance);

/// Area of a polygon, positive when its corners run counter-clockwise [m²].
double compute_area(const Polyline& corners);

/// Whether `x` lies inside the polygon. Points of the outline may come out either way.
bool is_inside(const Point2& x, const Polyline& corners);

/// A place where the outline of a polygon crosses or touches itself; nothing when it is simple. `tolerance` in [m].
std::optional<Point2> find_self_contact(const Polyline& corners, double tolerance);

/// How one polygon lies to another.
enum class Relation { apart, inside, around, same, overlapping };

/// `a` is apart from, inside, around or the same as `b`; shared edges and corners (within `tolerance` [m]) are allowed
/// in all of these. Overlapping: neither.
Relation compare(const Polyline& a, const Polyline& b, double tolerance);

// Corners of the ground that point into the soil, such as a slope's toe. Stress and strain are singular there, and what
// the elements at such a corner lose is felt by the whole slope.

/// Corners of the plan's polygons inside the box around which there is soil on more than a half circle by at least 10°,
/// but not all around. In 3D each is the trace of a line along the extrusion.
std::vector<Point2> find_reentrant_corners(const Plan& plan);

/// The plan with elements of size / `finer` at its re-entrant corners, which reach the general size `reach` general
/// sizes away. `finer` = 1: the plan as it is.
Plan refine_corners(Plan plan, double finer, double reach);

// Where a section is divided whose soil moves to both sides, as an embankment does on soft ground.

/// A piece of soil that moved.
struct MovedSoil {
  double x = 0;       ///< where it lay [m]
  double across = 0;  ///< how far it moved towards larger x [m]
  double amount = 0;  ///< its mass or volume
};

/// Soil on the left of `x` moved in the direction `left` (-1, 1) of x, soil on its right in the other.
struct Divide {
  double x = 0;  ///< [m]
  int left = -1;
};

/// The place that best divides soil that moved towards smaller x by more than `threshold` [m] from soil that moved as
/// far towards larger x: that with the least soil on the wrong side of it. Nothing where less than a twentieth of the
/// soil moved one of the two ways, or where the two lie among one another.
std::optional<Divide> find_divide(std::vector<MovedSoil> soil, double threshold);

}  // namespace talus::mesh
