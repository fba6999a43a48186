// SPDX-License-Identifier: MIT
#include "run/bounds/kink_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace talus::run {

namespace {

/// Cells of the grid along each axis.
constexpr std::size_t cells = 64;
/// Distance below which points are one, over the size of the triangle: a tenth of `inwards`.
constexpr double same = 1e-7;
/// Angle between two lines below which there is no part between them.
constexpr double least_angle = 1e-5;
/// Lines in a triangle above which its quarters are divided instead, as the work grows with the cube of their number,
/// and how often.
constexpr std::size_t most_lines = 60;
constexpr int most_divisions = 8;

Vec<2> subtract(const Vec<2>& a, const Vec<2>& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
double cross(const Vec<2>& a, const Vec<2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

using Triangle = KinkPoints::Triangle;
using Segment = KinkPoints::Segment;

Weights find_weights(const Triangle& t, const Vec<2>& x) {
  const double whole = cross(subtract(t[1], t[0]), subtract(t[2], t[0]));
  const double second = cross(subtract(x, t[0]), subtract(t[2], t[0])) / whole,
               third = cross(subtract(t[1], t[0]), subtract(x, t[0])) / whole;
  return {1 - second - third, second, third};
}

/// Returns the ends of the lines and their crossings.
std::vector<Vec<2>> list_corners(const std::vector<Segment>& lines, double tolerance) {
  std::vector<Vec<2>> corners;
  const auto add = [&](const Vec<2>& x) {
    for (const Vec<2>& c : corners)
      if (std::abs(c[0] - x[0]) <= tolerance && std::abs(c[1] - x[1]) <= tolerance) return;
    corners.push_back(x);
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    add(lines[i].from);
    add(lines[i].to);
    for (std::size_t j = 0; j < i; ++j) {
      const Vec<2> u = subtract(lines[i].to, lines[i].from), v = subtract(lines[j].to, lines[j].from),
                   between = subtract(lines[j].from, lines[i].from);
      const double det = cross(u, v);
      if (std::abs(det) <= least_angle * std::hypot(u[0], u[1]) * std::hypot(v[0], v[1])) continue;
      const double s = cross(between, v) / det, t = cross(between, u) / det;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1) add({lines[i].from[0] + s * u[0], lines[i].from[1] + s * u[1]});
    }
  }
  return corners;
}

/// Returns the directions from a corner half way between the lines that meet there.
std::vector<double> list_directions(const std::vector<Segment>& lines, const Vec<2>& corner, double tolerance) {
  std::vector<double> angles, middles;
  for (const Segment& line : lines) {
    if (mesh::compute_distance(corner, line.from, line.to) > 2 * tolerance) continue;
    for (const Vec<2>& end : {line.from, line.to}) {
      const Vec<2> away = subtract(end, corner);
      if (std::hypot(away[0], away[1]) > 4 * tolerance) angles.push_back(std::atan2(away[1], away[0]));
    }
  }
  std::sort(angles.begin(), angles.end());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * std::numbers::pi;
    if (next - angles[i] >= least_angle) middles.push_back(0.5 * (angles[i] + next));
  }
  return middles;
}

}  // namespace

KinkPoints::KinkPoints(const std::vector<mesh::Polyline>& lines) {
  Vec<2> high;
  low_.fill(std::numeric_limits<double>::max());
  high.fill(std::numeric_limits<double>::lowest());
  for (const mesh::Polyline& line : lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      segments_.push_back({line[i], line[i + 1]});
      for (const Vec<2>& x : {line[i], line[i + 1]})
        for (std::size_t d = 0; d < 2; ++d) low_[d] = std::min(low_[d], x[d]), high[d] = std::max(high[d], x[d]);
    }
  if (segments_.empty()) return;
  for (std::size_t d = 0; d < 2; ++d)
    cell_[d] = std::max((high[d] - low_[d]) / cells, std::numeric_limits<double>::min());
  at_.resize(cells * cells);
  for (std::size_t s = 0; s < segments_.size(); ++s) {
    const auto [a, b] = segments_[s];
    const auto first = find_cell({std::min(a[0], b[0]), std::min(a[1], b[1])}),
               last = find_cell({std::max(a[0], b[0]), std::max(a[1], b[1])});
    for (std::size_t i = first[0]; i <= last[0]; ++i)
      for (std::size_t j = first[1]; j <= last[1]; ++j) at_[i * cells + j].push_back(s);
  }
}

std::array<std::size_t, 2> KinkPoints::find_cell(const Vec<2>& x) const {
  std::array<std::size_t, 2> cell{};
  for (std::size_t d = 0; d < 2; ++d)
    cell[d] = static_cast<std::size_t>(std::clamp((x[d] - low_[d]) / cell_[d], 0.0, static_cast<double>(cells - 1)));
  return cell;
}

/// Returns the parts of the segments in a triangle.
std::vector<Segment> KinkPoints::list_inside(const Triangle& triangle, double tolerance) const {
  const auto first = find_cell({std::min({triangle[0][0], triangle[1][0], triangle[2][0]}),
                                std::min({triangle[0][1], triangle[1][1], triangle[2][1]})}),
             last = find_cell({std::max({triangle[0][0], triangle[1][0], triangle[2][0]}),
                               std::max({triangle[0][1], triangle[1][1], triangle[2][1]})});
  std::vector<std::size_t> numbers;
  for (std::size_t i = first[0]; i <= last[0]; ++i)
    for (std::size_t j = first[1]; j <= last[1]; ++j)
      numbers.insert(numbers.end(), at_[i * cells + j].begin(), at_[i * cells + j].end());
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::vector<Segment> inside;
  for (const std::size_t s : numbers) {
    const auto& [a, b] = segments_[s];
    const Weights from = find_weights(triangle, a), to = find_weights(triangle, b);
    double start = 0, end = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      if (from[k] < 0 && to[k] < 0) end = -1;
      if ((from[k] < 0) == (to[k] < 0)) continue;
      const double at = from[k] / (from[k] - to[k]);
      from[k] < 0 ? start = std::max(start, at) : end = std::min(end, at);
    }
    const Vec<2> along = subtract(b, a);
    if (!((end - start) * std::hypot(along[0], along[1]) > tolerance)) continue;
    inside.push_back(
        {{a[0] + start * along[0], a[1] + start * along[1]}, {a[0] + end * along[0], a[1] + end * along[1]}});
  }
  return inside;
}

std::vector<Weights> KinkPoints::list(const Triangle& triangle) const {
  if (segments_.empty()) return {};
  std::vector<Vec<2>> places;
  add_places(triangle, most_divisions, places);
  std::vector<Weights> points;
  for (const Vec<2>& x : places) points.push_back(find_weights(triangle, x));
  return points;
}

void KinkPoints::add_places(const Triangle& triangle, int divisions, std::vector<Vec<2>>& places) const {
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec<2> side = subtract(triangle[(i + 1) % 3], triangle[i]);
    size = std::max(size, std::hypot(side[0], side[1]));
  }
  const double tolerance = same * size;
  std::vector<Segment> lines = list_inside(triangle, tolerance);
  if (lines.empty()) return;
  if (lines.size() > most_lines && divisions > 0) {
    Triangle middle;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t d = 0; d < 2; ++d) middle[i][d] = 0.5 * (triangle[i][d] + triangle[(i + 1) % 3][d]);
    for (std::size_t i = 0; i < 3; ++i)
      add_places({triangle[i], middle[i], middle[(i + 2) % 3]}, divisions - 1, places);
    return add_places(middle, divisions - 1, places);
  }
  for (std::size_t i = 0; i < 3; ++i) lines.push_back({triangle[i], triangle[(i + 1) % 3]});
  for (const Vec<2>& corner : list_corners(lines, tolerance))
    for (const double angle : list_directions(lines, corner, tolerance)) {
      const Vec<2> x{corner[0] + inwards * size * std::cos(angle), corner[1] + inwards * size * std::sin(angle)};
      const Weights w = find_weights(triangle, x);
      if (*std::min_element(w.begin(), w.end()) > 0) places.push_back(x);
    }
}

}  // namespace talus::run
