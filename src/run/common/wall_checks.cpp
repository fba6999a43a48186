// SPDX-License-Identifier: MIT
#include "run/common/wall_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "input/case/support.hpp"
#include "mesh/planar.hpp"
#include "run/common/head.hpp"

namespace talus::run {
namespace {

/// Fractions of the width of the section: the shortest wall, and the distance at which two places are one.
constexpr double shortest_wall = 1e-3, same_place = 1e-7;
/// Distance of the places that are probed beside a wall, over the width of the section.
constexpr double probe_step = 1e-5;

struct Piece {
  site::Point a{}, b{};
  double length() const { return std::hypot(b[0] - a[0], b[1] - a[1]); }
};

std::vector<Piece> list_pieces(const WallLine& wall) {
  std::vector<Piece> pieces;
  for (std::size_t i = 1; i < wall.points.size(); ++i) pieces.push_back({wall.points[i - 1], wall.points[i]});
  return pieces;
}

/// Returns true if two pieces have more than a point in common.
bool do_overlap(const Piece& p, const Piece& q, double near) {
  int on = 0;
  for (const site::Point* x : {&p.a, &p.b}) on += mesh::compute_distance(*x, q.a, q.b) <= near;
  if (on == 2) return true;
  for (const site::Point* x : {&q.a, &q.b}) on += mesh::compute_distance(*x, p.a, p.b) <= near;
  // Two pieces that meet end to end have one end each on the other.
  const auto is_same = [&](const site::Point& x, const site::Point& y) {
    return std::hypot(x[0] - y[0], x[1] - y[1]) <= near;
  };
  const bool meets = is_same(p.a, q.a) || is_same(p.a, q.b) || is_same(p.b, q.a) || is_same(p.b, q.b);
  return on > (meets ? 2 : 1);
}

/// Judges walls against the soil of a section.
class WallChecks {
 public:
  explicit WallChecks(const site::Site& site)
      : site_(site), unit_(site.data().units().length), width_(site.ground().back()[0] - site.ground().front()[0]) {}

  void check_length(const WallLine& wall) const {
    double length = 0;
    for (const Piece& p : list_pieces(wall)) length += p.length();
    if (length < shortest_wall * width_)
      fail(wall, "is {} long, less than {} of the width of the section", format_value(length, unit_, 3), shortest_wall);
  }

  void check_pair(const WallLine& one, const WallLine& other) const {
    for (const Piece& p : list_pieces(one))
      for (const Piece& q : list_pieces(other))
        if (do_overlap(p, q, same_place * width_))
          fail(one, "and wall '{}' lie on each other near {}", other.support, format_point(q.a, unit_));
  }

  /// Checks the place of a wall in the soil of the polygons.
  void check_place(const WallLine& wall) const {
    if (polygons().empty()) return;
    for (const Piece& p : list_pieces(wall)) {
      const site::Point middle{0.5 * (p.a[0] + p.b[0]), 0.5 * (p.a[1] + p.b[1])};
      for (const double way : {-1.0, 1.0}) {
        const site::Point x = step_aside(p, middle, way);
        if (!is_soil(x) && has_soil(x, 1) && !has_soil(x, -1))
          fail(wall, "lies along the bottom of the section from {} to {}", format_point(p.a, unit_),
               format_point(p.b, unit_));
      }
    }
  }

 private:
  template <class... Args>
  [[noreturn]] void fail(const WallLine& wall, fmt::format_string<Args...> text, Args&&... args) const {
    fail_input("wall '{}' {}", wall.support, fmt::format(text, std::forward<Args>(args)...));
  }

  const std::vector<mesh::Polygon>& polygons() const { return site_.data().mesh.polygons; }

  bool is_soil(const site::Point& x) const {
    return std::any_of(polygons().begin(), polygons().end(),
                       [&](const mesh::Polygon& polygon) { return mesh::is_inside(x, polygon.points); });
  }

  /// Returns true if there is soil above (`way` 1) or below (-1) a place.
  bool has_soil(const site::Point& x, double way) const {
    for (const mesh::Polygon& polygon : polygons())
      for (std::size_t i = 0; i < polygon.points.size(); ++i) {
        const auto &a = polygon.points[i], &b = polygon.points[(i + 1) % polygon.points.size()];
        if ((a[0] <= x[0]) == (b[0] <= x[0])) continue;
        if (way * (a[1] + (b[1] - a[1]) * (x[0] - a[0]) / (b[0] - a[0]) - x[1]) > 0) return true;
      }
    return false;
  }

  /// Returns a place beside a place of a piece; `way` is +1 to the left of its direction and -1 to the right.
  site::Point step_aside(const Piece& p, const site::Point& x, double way) const {
    const double step = way * probe_step * width_ / p.length();
    return {x[0] - step * (p.b[1] - p.a[1]), x[1] + step * (p.b[0] - p.a[0])};
  }

  const site::Site& site_;
  const ShownUnit& unit_;
  double width_;
};

}  // namespace

void check_walls(const site::Site& site, const std::vector<WallLine>& walls) {
  if (walls.empty()) return;
  const WallChecks checks(site);
  for (const WallLine& wall : walls) checks.check_length(wall);
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (std::size_t j = i + 1; j < walls.size(); ++j) checks.check_pair(walls[i], walls[j]);
  for (const WallLine& wall : walls) checks.check_place(wall);
}

}  // namespace talus::run
