// SPDX-License-Identifier: MIT
#include "run/bounds/kink_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "mesh/generate.hpp"
#include "mesh/planar.hpp"
#include "run/bounds/soil_kinks.hpp"
#include "run/common/mesh_estimate.hpp"

namespace talus::run {

namespace {

using mesh::Point2;
using mesh::Polyline;

/// Distance of a line from others, distance of its end from a corner, which it then meets, and its length, over the
/// element size; the first is that below which the line is left out, the last as well.
constexpr double least_gap = 0.1, at_corner = 0.05, least_length = 0.25;
/// Length of the parts of a line that are left out one by one, over the element size, and points of each at which the
/// distance is measured, of which more than `most_near` are too near.
constexpr double part_length = 2;
constexpr int line_samples = 5, most_near = 2;
/// Triangles with these lines over those without, above which there are none.
constexpr double most_growth = 2;
constexpr double few_triangles = 100;

class KinkLines {
 public:
  KinkLines(const site::Site& site, mesh::Plan plan) : site_(site), data_(site_.data()), plan_(std::move(plan)) {}

  mesh::Plan build() {
    const std::vector<mesh::Polygon> polygons = plan_.polygons;
    for (const mesh::Polygon& polygon : polygons) {
      const auto region = data_.regions.find(polygon.name);
      if (region == data_.regions.end()) continue;
      const input::Material& soil = data_.materials.at(region->second);
      for (const Polyline& line : list_kinks(site_, plan_, soil, KinkDetail::meshed)) add(line, polygon.points);
    }
    return std::move(plan_);
  }

 private:
  /// Adds the parts of a line inside a polygon.
  void add(const Polyline& line, const Polyline& polygon) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Point2 &a = line[i], &b = line[i + 1];
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      if (!(length > 0)) continue;
      const auto find_place = [&](double s) { return Point2{a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])}; };
      std::vector<double> cuts = cut(a, b, polygon);
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        if (!mesh::is_inside(find_place(0.5 * (cuts[k] + cuts[k + 1])), polygon)) continue;
        const double whole = cuts[k + 1] - cuts[k];
        const int parts = std::max(1, static_cast<int>(whole * length / (part_length * plan_.size)));
        for (int p = 0; p < parts; ++p)
          add_part(find_place(cuts[k] + whole * p / parts), find_place(cuts[k] + whole * (p + 1) / parts));
      }
    }
  }

  /// Returns the places from 0 to 1, of a segment and of its crossings with the outline of a polygon, in their order.
  static std::vector<double> cut(const Point2& a, const Point2& b, const Polyline& polygon) {
    std::vector<double> cuts{0, 1};
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double ex = q[0] - p[0], ey = q[1] - p[1], det = dx * ey - dy * ex;
      if (det == 0) continue;
      const double s = ((p[0] - a[0]) * ey - (p[1] - a[1]) * ex) / det,
                   t = ((p[0] - a[0]) * dy - (p[1] - a[1]) * dx) / det;
      if (s > 0 && s < 1 && t >= 0 && t <= 1) cuts.push_back(s);
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
  }

  void add_part(Point2 from, Point2 to) {
    for (Point2* end : {&from, &to})
      for (const mesh::Polygon& polygon : plan_.polygons)
        for (const Point2& corner : polygon.points)
          if (std::hypot(corner[0] - (*end)[0], corner[1] - (*end)[1]) < at_corner * plan_.size) *end = corner;
    if (std::hypot(to[0] - from[0], to[1] - from[1]) < least_length * plan_.size) return;
    int near = 0;
    for (int i = 0; i < line_samples; ++i) {
      const double s = (i + 0.5) / line_samples;
      near += is_near({from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])}) ? 1 : 0;
    }
    if (near > most_near) return;
    plan_.lines.push_back({fmt::format("kink {}", plan_.lines.size() + 1), {from, to}});
  }

  bool is_near(const Point2& x) const {
    const double away = least_gap * plan_.size;
    return std::any_of(plan_.polygons.begin(), plan_.polygons.end(),
                       [&](const mesh::Polygon& p) {
                         return mesh::compute_distance(x, mesh::close_polygon(p.points)) < away;
                       }) ||
           std::any_of(plan_.lines.begin(), plan_.lines.end(),
                       [&](const mesh::Line& l) { return mesh::compute_distance(x, l.points) < away; });
  }

  const site::Site& site_;
  const input::Case& data_;
  mesh::Plan plan_;
};

std::size_t count_triangles(const mesh::Mesh<2>& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.element_region.begin(), mesh.element_region.end(),
                                                [](int region) { return region != mesh::empty_region; }));
}

}  // namespace

mesh::Mesh<2> generate_with_kinks(const site::Site& site, const mesh::Plan& plan) {
  if (!plan.file.empty()) return mesh::generate<2>(plan);
  const mesh::Plan bent = KinkLines(site, plan).build();
  if (bent.lines.size() == plan.lines.size()) return mesh::generate<2>(plan);
  try {
    mesh::Mesh<2> mesh = mesh::generate<2>(bent);
    if (static_cast<double>(count_triangles(mesh)) <= most_growth * count_elements(plan).soil + few_triangles)
      return mesh;
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
  }
  return mesh::generate<2>(plan);
}

}  // namespace talus::run
