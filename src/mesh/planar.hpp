// SPDX-License-Identifier: MIT
#pragma once
// Plane geometry of polygons and polylines, re-entrant corners, and the divide between soil that moves to either side.

#include <array>
#include <optional>
#include <vector>

#include "mesh/plan.hpp"

namespace talus::mesh {

using Point2 = std::array<double, 2>;
using Polyline = std::vector<Point2>;

/// Returns the distance of `x` from the segment a-b, or from the point a = b [m].
double compute_distance(const Point2& x, const Point2& a, const Point2& b);

/// Returns the distance of `x` from a polyline, or from its single point [m].
double compute_distance(const Point2& x, const Polyline& line);

/// Returns the outline of a polygon as a polyline that ends at its first point.
Polyline close_polygon(const Polyline& corners);

/// Returns the corners of a line, or of a closed polygon from its leftmost corner: points within `tolerance` [m] of the
/// straight line between their neighbours are removed.
Polyline drop_straight_points(const Polyline& line, bool closed, double tolerance);

/// Returns the area of a polygon, positive for counter-clockwise corners [m²].
double compute_area(const Polyline& corners);

/// Returns true if `x` lies inside the polygon; undefined for points on the outline.
bool is_inside(const Point2& x, const Polyline& corners);

/// Returns a point at which the outline of a polygon crosses or touches itself; std::nullopt for a simple polygon.
/// `tolerance` in [m].
std::optional<Point2> find_self_contact(const Polyline& corners, double tolerance);

/// Relation of one polygon to another.
enum class Relation { apart, inside, around, same, overlapping };

/// Compares `a` with `b`; shared edges and corners (within `tolerance` [m]) are allowed in every relation. The result
/// is `overlapping` if no other relation holds.
Relation compare(const Polyline& a, const Polyline& b, double tolerance);

// Re-entrant corners of the ground, such as a slope's toe. Stress and strain are singular there, and the discretisation
// error of the elements at such a corner affects the whole slope.

/// Returns the corners of the plan's polygons inside the box at which the soil angle exceeds a half circle by at least
/// 10° but is not a full circle. In 3D each is the trace of a line along the extrusion.
std::vector<Point2> find_reentrant_corners(const Plan& plan);

/// Returns the plan with elements of size / `finer` at its re-entrant corners, graded to the general size over a
/// distance of `reach` general sizes. With `finer` = 1 the plan is unchanged.
Plan refine_corners(Plan plan, double finer, double reach);

// Divide of a section whose soil moves to both sides, as an embankment on soft ground does.

/// A piece of displaced soil.
struct MovedSoil {
  double x = 0;       ///< initial position [m]
  double across = 0;  ///< displacement along x [m]
  double amount = 0;  ///< mass or volume
};

/// Soil left of `x` moved in the direction `left` (-1, 1) of x, soil right of it in the opposite direction.
struct Divide {
  double x = 0;  ///< [m]
  int left = -1;
};

/// Returns the best divide between soil that moved towards smaller x by more than `threshold` [m] and soil that moved
/// as far towards larger x, with the least soil on the wrong side. Returns std::nullopt if less than a twentieth of the
/// moved soil moved in one of the directions, or if both kinds of soil are intermixed.
std::optional<Divide> find_divide(std::vector<MovedSoil> soil, double threshold);

}  // namespace talus::mesh
