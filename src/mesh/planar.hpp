// SPDX-License-Identifier: MIT
#pragma once
// Plane geometry of polygons and polylines, with one tolerance for all that coincides.

#include <array>
#include <optional>
#include <utility>
#include <vector>

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

}  // namespace talus::mesh
