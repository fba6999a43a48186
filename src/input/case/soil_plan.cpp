// SPDX-License-Identifier: MIT
#include "input/case/soil_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "input/case/case.hpp"

namespace talus::input {

using mesh::Point2;

namespace {

/// Distance beside a line at which soil is looked for, over the size of elements. Corners may deviate by the tolerance
/// of the mesh generator, 1e-6 of an element.
constexpr double beside = 1e-3;

double get_step(const mesh::Plan& plan, double length) {
  return beside * (plan.size > 0 ? plan.size : length);
}

}  // namespace

SoilPlan::SoilPlan(const Case& data, const mesh::Plan& plan) : plan_(plan) {
  for (const mesh::Polygon& polygon : plan.polygons) {
    const auto region = data.regions.find(polygon.name);
    const auto material = region == data.regions.end() ? data.materials.end() : data.materials.find(region->second);
    wet_.push_back(material == data.materials.end() || material->second.water.is_wet());
  }
}

/// Returns places on a segment: in its middle between the outlines of polygons that it meets, and 32 more.
std::vector<Point2> SoilPlan::list_places(const Point2& a, const Point2& b) const {
  constexpr int more = 32;
  const Point2 along{b[0] - a[0], b[1] - a[1]};
  const double square = along[0] * along[0] + along[1] * along[1], step = get_step(plan_, std::sqrt(square));
  std::vector<double> ends;
  for (int i = 0; i <= more; ++i) ends.push_back(static_cast<double>(i) / more);
  const auto cross = [&](const Point2& x) { return along[0] * (x[1] - a[1]) - along[1] * (x[0] - a[0]); };
  const auto project = [&](const Point2& x) { return (along[0] * (x[0] - a[0]) + along[1] * (x[1] - a[1])) / square; };
  for (const mesh::Polygon& polygon : plan_.polygons)
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
      const Point2 &p = polygon.points[i], &q = polygon.points[(i + 1) % polygon.points.size()];
      const double at_p = cross(p), at_q = cross(q);
      if (std::abs(at_p) <= step * std::sqrt(square)) ends.push_back(project(p));
      if ((at_p < 0) == (at_q < 0)) continue;
      const double t = at_p / (at_p - at_q);
      ends.push_back(project({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])}));
    }
  std::erase_if(ends, [](double s) { return !(s >= 0 && s <= 1); });
  std::sort(ends.begin(), ends.end());
  std::vector<Point2> places;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double s = (ends[i] + ends[i + 1]) / 2;
    if (ends[i + 1] > ends[i]) places.push_back({a[0] + s * along[0], a[1] + s * along[1]});
  }
  return places;
}

Border SoilPlan::look_along(const mesh::Polyline& line) const {
  Border border;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point2 &a = line[i], &b = line[i + 1];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    if (length == 0) continue;
    const double step = get_step(plan_, length);
    const Point2 across{-(b[1] - a[1]) / length * step, (b[0] - a[0]) / length * step};
    for (const Point2& x : list_places(a, b)) {
      const Point2 left{x[0] + across[0], x[1] + across[1]}, right{x[0] - across[0], x[1] - across[1]};
      const bool soil_left = has_soil(left), soil_right = has_soil(right);
      border.meets_soil |= soil_left || soil_right;
      border.meets_air |= (soil_left && is_room(right)) || (soil_right && is_room(left));
      const bool water_left = has_water(left), water_right = has_water(right);
      border.is_surface |= water_left != water_right;
      border.is_within |= water_left && water_right;
    }
  }
  return border;
}

bool SoilPlan::has_water_at(const Point2& x) const {
  const double step = get_step(plan_, 1);
  for (const double dx : {-step, 0.0, step})
    for (const double dy : {-step, 0.0, step})
      if (has_water({x[0] + dx, x[1] + dy})) return true;
  return false;
}

bool SoilPlan::meets_water(const mesh::Polyline& line) const {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const std::vector<Point2> places = list_places(line[i], line[i + 1]);
    if (std::any_of(places.begin(), places.end(), [&](const Point2& x) { return has_water_at(x); })) return true;
  }
  return false;
}

std::pair<double, double> SoilPlan::find_levels() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> levels{infinity, -infinity};
  for (const mesh::Polygon& polygon : plan_.polygons)
    for (const Point2& x : polygon.points) levels = {std::min(levels.first, x[1]), std::max(levels.second, x[1])};
  return levels;
}

/// Returns the innermost polygon at a point, -1 where there is none: one inside another replaces it there.
int SoilPlan::find_polygon(const Point2& x) const {
  int found = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < plan_.polygons.size(); ++i) {
    const mesh::Polyline& points = plan_.polygons[i].points;
    if (!mesh::is_inside(x, points)) continue;
    const double area = std::abs(mesh::compute_area(points));
    if (area < least) least = area, found = static_cast<int>(i);
  }
  return found;
}

bool SoilPlan::has_soil(const Point2& x) const {
  return find_polygon(x) >= 0;
}

bool SoilPlan::has_water(const Point2& x) const {
  const int polygon = find_polygon(x);
  return polygon >= 0 && wet_[static_cast<std::size_t>(polygon)] != 0;
}

bool SoilPlan::is_room(const Point2& x) const {
  return !has_soil(x) && x[0] > plan_.box_min[0] && x[0] < plan_.box_max[0] && x[1] > plan_.box_min[1] &&
         x[1] < plan_.box_max[1];
}

}  // namespace talus::input
