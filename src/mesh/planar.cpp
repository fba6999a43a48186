// SPDX-License-Identifier: MIT
#include "mesh/planar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/plan.hpp"

namespace talus::mesh {

namespace {

double cross(const Point2& o, const Point2& a, const Point2& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

Point2 interpolate(const Point2& a, const Point2& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

/// Returns the position of the projection of `x` on a-b, from 0 at a to 1 at b, limited to that range.
double project(const Point2& x, const Point2& a, const Point2& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
  return square > 0 ? std::clamp(((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
}

/// Returns the position on a-b of its intersection with c-d; std::nullopt if they are parallel or do not intersect.
std::optional<double> find_crossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double ca = cross(c, d, a), cb = cross(c, d, b), ac = cross(a, b, c), ad = cross(a, b, d);
  if ((ca > 0) == (cb > 0) || (ac > 0) == (ad > 0)) return std::nullopt;
  return ca / (ca - cb);
}

/// Marks the corners between two corners: the point with the largest distance from the straight line between them, and
/// so on recursively (Douglas and Peucker 1973). Points of straight edges are never marked.
void mark_corners(const Polyline& line, std::size_t from, std::size_t to, double tolerance, std::vector<char>& kept) {
  double most = tolerance;
  std::size_t farthest = from;
  for (std::size_t i = from + 1; i < to; ++i)
    if (const double distance = compute_distance(line[i], line[from], line[to]); distance > most)
      most = distance, farthest = i;
  if (farthest == from) return;
  kept[farthest] = 1;
  mark_corners(line, from, farthest, tolerance, kept);
  mark_corners(line, farthest, to, tolerance, kept);
}

/// Flags for parts of the outline of `a` inside and outside of `b`; parts on the outline of `b` set neither.
struct Parts {
  bool inside = false, outside = false;
};

Parts find_parts(const Polyline& a, const Polyline& b, double tolerance) {
  const Polyline outline = close_polygon(a), other = close_polygon(b);
  Parts parts;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const Point2 &p = outline[i], &q = outline[i + 1];
    std::vector<double> cuts{0, 1};
    for (std::size_t j = 0; j + 1 < other.size(); ++j) {
      if (const auto t = find_crossing(p, q, other[j], other[j + 1])) cuts.push_back(*t);
      if (compute_distance(other[j], p, q) <= tolerance) cuts.push_back(project(other[j], p, q));
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      // Between two cuts the segment is on one side, so its midpoint decides.
      const Point2 middle = interpolate(p, q, (cuts[k] + cuts[k + 1]) / 2);
      if (compute_distance(middle, other) <= tolerance) continue;
      (is_inside(middle, b) ? parts.inside : parts.outside) = true;
    }
  }
  return parts;
}

/// Returns true if the bounding boxes of two polygons are more than `tolerance` [m] apart.
bool are_boxes_apart(const Polyline& a, const Polyline& b, double tolerance) {
  for (std::size_t d = 0; d < 2; ++d) {
    const auto by_place = [d](const Point2& p, const Point2& q) { return p[d] < q[d]; };
    const auto [low_a, high_a] = std::minmax_element(a.begin(), a.end(), by_place);
    const auto [low_b, high_b] = std::minmax_element(b.begin(), b.end(), by_place);
    if ((*low_b)[d] - (*high_a)[d] > tolerance || (*low_a)[d] - (*high_b)[d] > tolerance) return true;
  }
  return false;
}

}  // namespace

double compute_distance(const Point2& x, const Point2& a, const Point2& b) {
  const Point2 foot = interpolate(a, b, project(x, a, b));
  return std::hypot(x[0] - foot[0], x[1] - foot[1]);
}

double compute_distance(const Point2& x, const Polyline& line) {
  if (line.size() == 1) return compute_distance(x, line[0], line[0]);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    nearest = std::min(nearest, compute_distance(x, line[i], line[i + 1]));
  return nearest;
}

Polyline close_polygon(const Polyline& corners) {
  Polyline outline = corners;
  outline.push_back(corners.front());
  return outline;
}

Polyline drop_straight_points(const Polyline& line, bool closed, double tolerance) {
  if (line.size() < 3) return line;
  if (!closed) {
    std::vector<char> kept(line.size(), 0);
    kept.front() = kept.back() = 1;
    mark_corners(line, 0, line.size() - 1, tolerance, kept);
    Polyline corners;
    for (std::size_t i = 0; i < line.size(); ++i)
      if (kept[i]) corners.push_back(line[i]);
    return corners;
  }
  // The leftmost point and the one farthest from it are corners of a polygon; the two lines between them are open.
  Polyline outline = line;
  std::rotate(outline.begin(), std::min_element(outline.begin(), outline.end()), outline.end());
  const auto far = std::max_element(outline.begin(), outline.end(), [&](const Point2& a, const Point2& b) {
    return compute_distance(a, outline[0], outline[0]) < compute_distance(b, outline[0], outline[0]);
  });
  Polyline corners = drop_straight_points({outline.begin(), far + 1}, false, tolerance);
  Polyline back(far, outline.end());
  back.push_back(outline.front());
  back = drop_straight_points(back, false, tolerance);
  corners.insert(corners.end(), back.begin() + 1, back.end() - 1);
  return corners;
}

double compute_area(const Polyline& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    twice += cross(corners[0], corners[i], corners[(i + 1) % corners.size()]);
  return twice / 2;
}

bool is_inside(const Point2& x, const Polyline& corners) {
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Point2 &a = corners[i], &b = corners[j];
    if ((a[1] > x[1]) == (b[1] > x[1])) continue;
    if (x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
  }
  return inside;
}

std::optional<Point2> find_self_contact(const Polyline& corners, double tolerance) {
  const Polyline outline = close_polygon(corners);
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      if (i == j) continue;
      const Point2 &a = outline[i], &b = outline[i + 1];
      // A corner on an edge that it does not belong to: the outline touches itself or turns back.
      if (j != (i + 1) % count && compute_distance(corners[j], a, b) <= tolerance) return corners[j];
      const bool share_a_corner = (i + 1) % count == j || (j + 1) % count == i;
      if (share_a_corner) continue;
      // Due to rounding, collinear edges may intersect, at a point that is on only one of them.
      if (const auto t = find_crossing(a, b, outline[j], outline[j + 1]))
        if (const Point2 at = interpolate(a, b, *t); compute_distance(at, outline[j], outline[j + 1]) <= tolerance)
          return at;
    }
  return std::nullopt;
}

Relation compare(const Polyline& a, const Polyline& b, double tolerance) {
  if (are_boxes_apart(a, b, tolerance)) return Relation::apart;
  const Parts of_a = find_parts(a, b, tolerance), of_b = find_parts(b, a, tolerance);
  if ((of_a.inside && of_a.outside) || (of_b.inside && of_b.outside)) return Relation::overlapping;
  if (of_a.inside && of_b.inside) return Relation::overlapping;
  if (!of_a.inside && !of_a.outside && !of_b.inside && !of_b.outside) return Relation::same;
  // If the whole outline of one polygon is on that of the other, it is inside only if the rest of the other is outside.
  if (of_a.inside || (!of_a.outside && of_b.outside)) return Relation::inside;
  if (of_b.inside || (!of_b.outside && of_a.outside)) return Relation::around;
  return Relation::apart;
}

namespace {

/// Smallest excess of the soil angle over a half circle that makes a re-entrant corner.
constexpr double least_turn = 10 * std::numbers::pi / 180;
/// Sampling points around a corner, one per degree.
constexpr int looks = 360;

bool has_soil(const Plan& plan, const Point2& x) {
  return std::any_of(plan.polygons.begin(), plan.polygons.end(),
                     [&](const Polygon& polygon) { return is_inside(x, polygon.points); });
}

bool is_on_box(const Plan& plan, const Point2& x, double near) {
  for (int d = 0; d < 2; ++d)
    if (x[d] - plan.box_min[d] < near || plan.box_max[d] - x[d] < near) return true;
  return false;
}

/// Returns the angle of the soil around `x`, a point inside the box, at a distance of `radius`.
double measure_soil_angle(const Plan& plan, const Point2& x, double radius) {
  int soil = 0;
  for (int i = 0; i < looks; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / looks;
    soil += has_soil(plan, {x[0] + radius * std::cos(angle), x[1] + radius * std::sin(angle)});
  }
  return 2 * std::numbers::pi * soil / looks;
}

}  // namespace

// These two of plan.hpp are here and not beside the checks, because the module of Gmsh is linked with this file.

double get_tolerance(const Plan& plan) {
  return 1e-6 * plan.size;
}

double compute_size(const Plan& plan, const Point2& x) {
  double size = plan.size;
  for (const Refinement& r : plan.refinements) {
    const double share = std::min(1.0, compute_distance(x, r.near) / r.distance);
    size = std::min(size, r.size + share * (plan.size - r.size));
  }
  return size;
}

std::vector<Point2> find_reentrant_corners(const Plan& plan) {
  const double near = get_tolerance(plan), radius = 100 * near;
  std::vector<Point2> corners;
  for (const Polygon& polygon : plan.polygons)
    for (const Point2& x : polygon.points) {
      const bool known = std::any_of(corners.begin(), corners.end(),
                                     [&](const Point2& c) { return std::hypot(c[0] - x[0], c[1] - x[1]) <= near; });
      if (known || is_on_box(plan, x, radius)) continue;
      const double angle = measure_soil_angle(plan, x, radius);
      if (angle >= std::numbers::pi + least_turn && angle < 2 * std::numbers::pi - least_turn) corners.push_back(x);
    }
  return corners;
}

Plan refine_corners(Plan plan, double finer, double reach) {
  if (!(finer > 1)) return plan;
  for (const Point2& corner : find_reentrant_corners(plan))
    plan.refinements.push_back({{corner}, plan.size / finer, reach * plan.size});
  return plan;
}

namespace {

/// Smallest fraction of the moved soil that counts as a side of its own [-].
constexpr double least_side = 0.05;
/// Largest fraction of the smaller side on the wrong side of the divide [-].
constexpr double most_mixed = 0.25;

}  // namespace

std::optional<Divide> find_divide(std::vector<MovedSoil> soil, double threshold) {
  std::erase_if(soil, [&](const MovedSoil& s) { return !(std::abs(s.across) > threshold); });
  std::stable_sort(soil.begin(), soil.end(), [](const MovedSoil& a, const MovedSoil& b) { return a.x < b.x; });
  double to_left = 0, to_right = 0;
  for (const MovedSoil& s : soil) (s.across < 0 ? to_left : to_right) += s.amount;
  const double all = to_left + to_right, smaller = std::min(to_left, to_right);
  if (!(smaller > 0) || smaller < least_side * all) return std::nullopt;
  // `wrong` is the amount on the wrong side if soil left of the divide should move to the left. It starts at the amount
  // that moved to the left, for a divide before all soil; each piece that the divide passes is subtracted or added.
  Divide best;
  double wrong = to_left, fewest = most_mixed * smaller;
  bool found = false;
  for (std::size_t i = 0; i + 1 < soil.size(); ++i) {
    wrong += soil[i].across < 0 ? -soil[i].amount : soil[i].amount;
    const double least = std::min(wrong, all - wrong);
    if (least >= fewest) continue;
    fewest = least;
    best = {0.5 * (soil[i].x + soil[i + 1].x), wrong < all - wrong ? -1 : 1};
    found = true;
  }
  return found ? std::optional(best) : std::nullopt;
}

}  // namespace talus::mesh
