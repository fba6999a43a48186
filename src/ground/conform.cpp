// SPDX-License-Identifier: MIT
#include "ground/conform.hpp"

#include <algorithm>
#include <cmath>

#include "ground/ground_line.hpp"
#include "ground/initial_water.hpp"
#include "ground/plane_water.hpp"

namespace talus::ground {
namespace {

/// A place nearer to a corner is that corner, as a fraction of the section's width.
constexpr double same_place = 1e-7;

/// Adds the places where the water table meets the ground, and its breaks above the ground.
void add_table(const Polyline& table, const Polyline& ground, std::vector<double>& places) {
  std::vector<double> breaks;
  for (const Point& x : table) breaks.push_back(x[0]);
  for (const Point& x : ground) breaks.push_back(x[0]);
  std::sort(breaks.begin(), breaks.end());
  const auto find_depth = [&](double x) { return find_water_table(table, x) - find_level(ground, x); };
  for (const Point& x : table)
    if (find_depth(x[0]) > 0) places.push_back(x[0]);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    // Both lines are straight between two breaks; at a step of the ground its level jumps.
    const double length = breaks[i + 1] - breaks[i];
    if (!(length > 0)) continue;
    const double p = find_depth(breaks[i] + length / 3), q = find_depth(breaks[i] + 2 * length / 3);
    const double at = p == q ? -1 : 1.0 / 3 + p / (3 * (p - q));
    if (at > 0 && at < 1) places.push_back(breaks[i] + at * length);
  }
}

std::vector<Point> list_places(const input::Case& data, const Polyline& ground) {
  std::vector<double> places;
  for (const input::Surcharge& s : data.surcharges) places.insert(places.end(), s.x.begin(), s.x.end());
  for (const Pond& p : find_ponds(data, ground, find_first_time(data)))
    places.push_back(p.from[0]), places.push_back(p.to[0]);
  if (data.initial.water.pressure == input::InitialPressure::water_table && !data.initial.water.water_table.empty())
    add_table(data.initial.water.water_table, ground, places);
  std::vector<Point> on_ground;
  for (const double x : places)
    if (x > ground.front()[0] && x < ground.back()[0]) on_ground.push_back({x, find_level(ground, x)});
  return on_ground;
}

/// The corners of a polygon and those of `places` that lie on its outline.
Polyline add_corners(const Polyline& corners, const std::vector<Point>& places, double least) {
  Polyline all;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
    std::vector<double> along;
    for (const Point& x : places) {
      const double s = ((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / length,
                   off = ((x[0] - a[0]) * dy - (x[1] - a[1]) * dx) / length;
      if (s > least && s < length - least && std::abs(off) <= least) along.push_back(s / length);
    }
    std::sort(along.begin(), along.end());
    all.push_back(a);
    for (std::size_t k = 0; k < along.size(); ++k)
      if (k == 0 || (along[k] - along[k - 1]) * length > least)
        all.push_back({a[0] + along[k] * dx, a[1] + along[k] * dy});
  }
  return all;
}

}  // namespace

mesh::Plan conform_to_loads(const input::Case& data, mesh::Plan plan) {
  if (plan.dimension != 2 || !plan.file.empty() || plan.polygons.empty()) return plan;
  const Polyline ground = find_ground(plan);
  const std::vector<Point> places = list_places(data, ground);
  if (places.empty()) return plan;
  const double least = same_place * (ground.back()[0] - ground.front()[0]);
  for (mesh::Polygon& polygon : plan.polygons) polygon.points = add_corners(polygon.points, places, least);
  return plan;
}

}  // namespace talus::ground
