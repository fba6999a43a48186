// SPDX-License-Identifier: MIT
// The ground line as the upper limit of the polygons of a plan.
#include "mesh/ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "base/numbers.hpp"

namespace talus::mesh {

namespace {

/// Lengths below this fraction of the section's width count as zero.
constexpr double nothing = 1e-9;

struct Edge {
  Point2 a{}, b{};  ///< a[0] < b[0]
  int polygon = 0;
  double at(double x) const { return a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]); }
  bool spans(double x) const { return a[0] < x && x < b[0]; }
};

std::vector<Edge> list_edges(const Plan& plan, double least) {
  std::vector<Edge> edges;
  for (std::size_t p = 0; p < plan.polygons.size(); ++p) {
    const auto& corners = plan.polygons[p].points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Point2 a = corners[i], b = corners[(i + 1) % corners.size()];
      if (std::abs(a[0] - b[0]) <= least) continue;  // a vertical edge bounds no soil above or below
      if (a[0] > b[0]) std::swap(a, b);
      edges.push_back({a, b, static_cast<int>(p)});
    }
  }
  return edges;
}

/// Returns all x at which the order of the edges may change.
std::vector<double> list_breaks(const std::vector<Edge>& edges, double least) {
  std::vector<double> breaks;
  for (const Edge& e : edges) {
    breaks.push_back(e.a[0]);
    breaks.push_back(e.b[0]);
    for (const Edge& f : edges) {
      const double from = std::max(e.a[0], f.a[0]), to = std::min(e.b[0], f.b[0]);
      if (to - from <= least) continue;
      const double before = e.at(from) - f.at(from), after = e.at(to) - f.at(to);
      if (before * after < 0) breaks.push_back(from + (to - from) * before / (before - after));
    }
  }
  std::sort(breaks.begin(), breaks.end());
  std::vector<double> distinct;
  for (const double x : breaks)
    if (distinct.empty() || x - distinct.back() > least) distinct.push_back(x);
  return distinct;
}

/// Throws Error (wrong_input) if the soil at `x` has a gap below its upper limit. `levels`: elevations of the edges at
/// x, with their polygons.
void check_column(std::vector<std::pair<double, int>> levels, double x, double least, const ShownUnit& length) {
  std::sort(levels.begin(), levels.end());
  std::vector<std::array<double, 2>> filled;
  std::vector<std::pair<int, double>> open;  // polygon, elevation of its lower limit
  for (const auto& [y, polygon] : levels) {
    const auto begun =
        std::find_if(open.begin(), open.end(), [polygon = polygon](const auto& o) { return o.first == polygon; });
    if (begun == open.end()) {
      open.emplace_back(polygon, y);
    } else {
      filled.push_back({begun->second, y});
      open.erase(begun);
    }
  }
  std::sort(filled.begin(), filled.end());
  double top = filled.empty() ? 0 : filled.front()[1];
  for (const auto& [from, to] : filled) {
    if (from - top > least)
      throw Error(ExitCode::wrong_input, fmt::format("the soil at x = {} has a gap between y = {} and {}: LEM, "
                                                     "and water and loads on the ground, need soil without overhangs "
                                                     "and cavities from the ground down",
                                                     format_coordinate(x, length), format_coordinate(top, length),
                                                     format_coordinate(from, length)));
    top = std::max(top, to);
  }
}

}  // namespace

Polyline find_ground(const Plan& plan) {
  double left = std::numeric_limits<double>::max(), right = std::numeric_limits<double>::lowest();
  for (const Polygon& p : plan.polygons)
    for (const Point2& x : p.points) left = std::min(left, x[0]), right = std::max(right, x[0]);
  const double least = nothing * (right - left);
  const std::vector<Edge> edges = list_edges(plan, least);
  const std::vector<double> breaks = list_breaks(edges, least);
  const ShownUnit& length = plan.units.length;
  Polyline ground;
  const auto add = [&](const Point2& x) {
    if (!ground.empty() && std::hypot(x[0] - ground.back()[0], x[1] - ground.back()[1]) <= 2 * least) return;
    ground.push_back(x);
  };
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double middle = (breaks[i] + breaks[i + 1]) / 2;
    const Edge* top = nullptr;
    std::vector<std::pair<double, int>> levels;
    for (const Edge& e : edges) {
      if (!e.spans(middle)) continue;
      levels.emplace_back(e.at(middle), e.polygon);
      if (top == nullptr || e.at(middle) > top->at(middle)) top = &e;
    }
    if (top == nullptr)
      throw Error(ExitCode::wrong_input,
                  fmt::format("there is no soil between x = {} and {}: LEM, and water and loads "
                              "on it, need a ground without gaps",
                              format_coordinate(breaks[i], length), format_coordinate(breaks[i + 1], length)));
    check_column(std::move(levels), middle, least, length);
    add({breaks[i], top->at(breaks[i])});
    add({breaks[i + 1], top->at(breaks[i + 1])});
  }
  return drop_straight_points(ground, false, least);
}

}  // namespace talus::mesh
