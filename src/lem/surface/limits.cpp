// SPDX-License-Identifier: MIT
// Straight lines against polygons, polylines and boxes, and the path along a layer.
#include "lem/surface/limits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace talus::lem {

namespace {

/// Places along a line that are nearer than this fraction of it are one place.
constexpr double rounding = 1e-9;

/// Returns the position of the intersection of the lines a–b and p–q along a–b, 0 to 1; none if they do not meet.
std::optional<double> find_meeting(const Point& a, const Point& b, const Point& p, const Point& q) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], ex = q[0] - p[0], ey = q[1] - p[1];
  const double across = dx * ey - dy * ex;
  if (across == 0) return std::nullopt;
  const double t = ((p[0] - a[0]) * ey - (p[1] - a[1]) * ex) / across;
  const double u = ((p[0] - a[0]) * dy - (p[1] - a[1]) * dx) / across;
  if (t < -rounding || t > 1 + rounding || u < -rounding || u > 1 + rounding) return std::nullopt;
  return std::clamp(t, 0.0, 1.0);
}

/// Returns true if a point is inside a polygon by more than `near` [m].
bool is_inside(const std::vector<Point>& polygon, const Point& p, double near) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
    if (std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy) <= near) return false;
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + dx * (p[1] - a[1]) / dy) inside = !inside;
  }
  return inside;
}

/// Returns the box around points, as its lower left and upper right corner.
std::array<Point, 2> find_box(const std::vector<Point>& points) {
  std::array<Point, 2> box{points.front(), points.front()};
  for (const Point& p : points)
    for (std::size_t i = 0; i < 2; ++i) box[0][i] = std::min(box[0][i], p[i]), box[1][i] = std::max(box[1][i], p[i]);
  return box;
}

bool misses_box(const std::array<Point, 2>& box, const Point& a, const Point& b) {
  return std::max(a[0], b[0]) < box[0][0] || std::min(a[0], b[0]) > box[1][0] || std::max(a[1], b[1]) < box[0][1] ||
         std::min(a[1], b[1]) > box[1][1];
}

}  // namespace

bool enters_polygon(const std::vector<Point>& polygon, const Point& a, const Point& b) {
  const auto box = find_box(polygon);
  if (misses_box(box, a, b)) return false;
  const double near = 1e-6 * std::hypot(box[1][0] - box[0][0], box[1][1] - box[0][1]);
  std::vector<double> places{0, 1};
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (const auto t = find_meeting(a, b, polygon[i], polygon[(i + 1) % polygon.size()])) places.push_back(*t);
  std::sort(places.begin(), places.end());
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (places[i] - places[i - 1] < rounding) continue;
    const double t = 0.5 * (places[i] + places[i - 1]);
    if (is_inside(polygon, {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}, near)) return true;
  }
  return false;
}

bool meets_window(const Window& window, const Point& a, const Point& b) {
  const std::vector<Point>& points = window.points;
  if (window.is_box) {
    if (misses_box({points[0], points[1]}, a, b)) return false;
    const auto is_in = [&](const Point& p) { return !misses_box({points[0], points[1]}, p, p); };
    const std::array<Point, 4> corners{points[0], Point{points[1][0], points[0][1]}, points[1],
                                       Point{points[0][0], points[1][1]}};
    bool meets = is_in(a) || is_in(b);
    for (std::size_t i = 0; i < 4 && !meets; ++i)
      meets = find_meeting(a, b, corners[i], corners[(i + 1) % 4]).has_value();
    return meets;
  }
  for (std::size_t i = 1; i < points.size(); ++i)
    if (find_meeting(a, b, points[i - 1], points[i])) return true;
  return false;
}

namespace {

/// Lowest and highest elevation of a polygon just left or right of x; none outside it.
std::optional<std::array<double, 2>> find_side(const std::vector<Point>& polygon, double x, bool right) {
  std::optional<std::array<double, 2>> sides;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (a[0] == b[0]) continue;
    const double low = std::min(a[0], b[0]), high = std::max(a[0], b[0]);
    if (right ? x < low || x >= high : x <= low || x > high) continue;
    const double y = a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
    sides = sides ? std::array{std::min((*sides)[0], y), std::max((*sides)[1], y)} : std::array{y, y};
  }
  return sides;
}

}  // namespace

Path make_path(const std::vector<std::vector<Point>>& polygons) {
  std::set<double> places;
  for (const auto& polygon : polygons)
    for (const Point& p : polygon) places.insert(p[0]);
  Path path;
  for (const double x : places)
    for (const bool right : {false, true}) {
      std::optional<std::array<double, 2>> sides;
      for (const auto& polygon : polygons)
        if (const auto own = find_side(polygon, x, right))
          sides = sides ? std::array{std::min((*sides)[0], (*own)[0]), std::max((*sides)[1], (*own)[1])} : *own;
      if (!sides) {
        if (x == (right ? *places.rbegin() : *places.begin())) continue;
        return {};  // a gap
      }
      if (!path.bottom.empty() && path.bottom.back()[0] == x) continue;
      path.bottom.push_back({x, (*sides)[0]});
      path.top.push_back({x, (*sides)[1]});
    }
  return path;
}

}  // namespace talus::lem
