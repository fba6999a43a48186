// SPDX-License-Identifier: MIT
#pragma once
// The section of limit analysis: triangles with strength, weight, pore pressures, loads and supports, in plane strain.
// Lengths are in metres, x to the right, y up. Stress is positive in tension: xx, yy, xy. Pore pressure is positive in
// compression.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "base/vec.hpp"
#include "bounds/walls.hpp"

namespace talus::bounds {

using Triangle = std::array<int, 3>;
/// Components xx, yy, xy [Pa].
using Stress = std::array<double, 3>;

/// A line of a concave envelope beside its first, steepest one.
struct FurtherLine {
  double more_cohesion = 0;  ///< over that of the first line [Pa]
  double tan_friction = 0;
};

/// Numbers of the first and the last line of an envelope.
struct LineRange {
  std::size_t first = 0, last = std::numeric_limits<std::size_t>::max();
};

/// Planes of one direction with a strength of their own, which F divides as that of the soil: |τ| ≤ c − σ' tan φ on
/// them, as on bedding.
struct WeakPlanes {
  double angle = 0;     ///< to the horizontal, positive where they rise with x [rad]
  double cohesion = 0;  ///< [Pa]
  double tan_friction = 0;
};

/// Strength at a corner of a triangle: |τ| ≤ c − σ' tan φ on every plane, for every line of the envelope, no effective
/// tension above `tension`, and the criterion of weak planes.
struct Strength {
  double cohesion = 0;            ///< c [Pa]
  double tan_friction = 0;        ///< tan φ
  std::optional<double> tension;  ///< largest effective tension, divided by F like c and tan φ [Pa]
  bool is_reduced = true;         ///< false: F does not divide the strength
  std::shared_ptr<const std::vector<FurtherLine>> further{};  ///< by falling tan φ; null: the envelope is straight
  std::shared_ptr<const WeakPlanes> planes{};                 ///< the same in all of a triangle; null: none
  LineRange programmed{};  ///< lines in the cone programs; what proves a bound is held to all lines

  /// Returns what the strength is divided by.
  double find_divisor(double factor) const { return is_reduced ? factor : 1; }
  double find_least_friction() const { return further ? further->back().tan_friction : tan_friction; }
  /// Returns the number of rows of its cones: three of a line and of the tension cut-off, two of weak planes.
  std::size_t count_rows() const {
    const std::size_t last = further ? further->size() : 0;
    return 3 * (std::min(last, programmed.last) - std::min(last, programmed.first) + 1 + (tension ? 1 : 0)) +
           (planes ? 2 : 0);
  }
  /// Calls use(more cohesion, tan φ) for every line.
  void visit_lines(auto use) const { visit(LineRange{}, use); }
  /// Calls it for those in the programs.
  void visit_programmed_lines(auto use) const { visit(programmed, use); }

 private:
  void visit(const LineRange& range, auto use) const {
    if (!further) return use(0.0, tan_friction);
    if (range.first == 0) use(0.0, tan_friction);
    for (std::size_t i = std::max<std::size_t>(1, std::min(range.first, further->size()));
         i <= std::min(further->size(), range.last); ++i)
      use((*further)[i - 1].more_cohesion, (*further)[i - 1].tan_friction);
  }
};

/// An edge of the border of the soil.
struct Side {
  int from = 0, to = 0;  ///< its nodes
  bool holds_normal = false, holds_along = false;
  std::array<Vec<2>, 2> traction{};  ///< total, at `from` and `to` [Pa]; used in free directions
};

/// A part of a straight support along an edge inside the soil. Its tension is the largest that the support can bear
/// there. A stress field in equilibrium with any fraction of that of a bar proves a lower bound, and a mechanism
/// extends it at no more than this force.
struct BarEdge {
  int from = 0, to = 0;           ///< its nodes, in the direction from the head
  std::array<double, 2> force{};  ///< tension at them, linear between [N/m]
  bool is_reduced = false;        ///< F divides the force (a passive support)
  std::size_t bar = 0;            ///< number of its bar
};

/// The head of a bar, whose tension there presses on sides of the border, evenly and in the direction of the bar, or on
/// a wall.
struct BarHead {
  int node = 0;        ///< where the bar begins
  Vec<2> direction{};  ///< of the bar, unit
  double force = 0;    ///< tension there [N/m]
  bool is_reduced = false;
  std::vector<std::array<int, 2>> sides{};  ///< nodes of the loaded sides
  std::optional<std::size_t> wall{};        ///< instead of sides: the wall on which it presses
  std::size_t bar = 0;                      ///< number of its bar
};

struct Problem {
  std::vector<Vec<2>> nodes;
  std::vector<Triangle> triangles;                   ///< counterclockwise
  std::vector<int> region;                           ///< of each triangle
  std::vector<std::array<Strength, 3>> strength;     ///< at its corners, linear between them
  std::vector<Vec<2>> body_force;                    ///< of each triangle, with its pore water [N/m³]
  std::vector<std::array<double, 3>> pore_pressure;  ///< at its corners, linear between them [Pa]
  std::vector<Side> sides;                           ///< of the border; a side that is not listed is free
  std::vector<BarEdge> bars;
  std::vector<BarHead> heads;
  std::vector<Wall> walls;

  std::size_t size() const { return triangles.size(); }
  std::size_t count_bars() const {
    std::size_t count = 0;
    for (const BarEdge& bar : bars) count = std::max(count, bar.bar + 1);
    return count;
  }
};

/// Area, and gradients of the shape functions of the three corners [1/m].
struct Shape {
  double area = 0;
  std::array<Vec<2>, 3> gradient{};
};

inline Shape find_shape(const Problem& problem, std::size_t e) {
  const Triangle& t = problem.triangles[e];
  const auto node = [&](std::size_t i) -> const Vec<2>& { return problem.nodes[static_cast<std::size_t>(t[i])]; };
  const Vec<2>&a = node(0), &b = node(1), &c = node(2);
  const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  Shape shape{0.5 * twice, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec<2>&p = node((i + 1) % 3), &q = node((i + 2) % 3);
    shape.gradient[i] = {(p[1] - q[1]) / twice, (q[0] - p[0]) / twice};
  }
  return shape;
}

/// Returns the gradients of the six quadratic shape functions (corners, then middles of 0–1, 1–2, 2–0) at corner c
/// [1/m].
inline std::array<Vec<2>, 6> find_quadratic_gradients(const Shape& shape, std::size_t c) {
  std::array<Vec<2>, 6> g{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    for (std::size_t d = 0; d < 2; ++d) {
      g[i][d] = (c == i ? 3 : -1) * shape.gradient[i][d];
      g[3 + i][d] = 4 * ((c == i ? shape.gradient[j][d] : 0) + (c == j ? shape.gradient[i][d] : 0));
    }
  }
  return g;
}

/// Constant traction of a support on the soil along an edge, with the largest tension.
struct LineForce {
  int from = 0, to = 0;
  double length = 0;  ///< [m]
  Vec<2> traction{};  ///< at factor 1 [Pa]
  bool is_reduced = false;
  std::size_t bar = 0;

  double find_divisor(double factor) const { return is_reduced ? factor : 1; }
};

/// Returns the part of the same bar that ends where a part begins.
inline std::optional<BarEdge> find_bar_above(const Problem& problem, const BarEdge& part) {
  for (const BarEdge& other : problem.bars)
    if (other.bar == part.bar && other.to == part.from) return other;
  return std::nullopt;
}

/// Returns the tractions of bars, by which their tension grows along them, and of their heads.
std::vector<LineForce> list_line_forces(const Problem& problem);

struct Units {
  double length = 1;  ///< [m]
  double stress = 1;  ///< [Pa]
};

/// Returns the units that make the numbers of a program about one: the height of the section, and the largest load or
/// overburden.
Units find_units(const Problem& problem);

// Mohr–Coulomb's criterion in plane strain with the strength divided by F (T21.1), and the F that a stress allows.

/// Radius R and centre σ_m of Mohr's circle.
struct Circle {
  double radius = 0, mean = 0;
};

inline Circle find_circle(const Stress& s) {
  return {std::hypot(0.5 * (s[0] - s[1]), s[2]), 0.5 * (s[0] + s[1])};
}

/// Normal and shear stress on a plane.
struct PlaneTraction {
  double normal = 0, shear = 0;
};

inline PlaneTraction find_plane_traction(const Stress& s, double angle) {
  const double mean = 0.5 * (s[0] + s[1]), half = 0.5 * (s[0] - s[1]), c = std::cos(2 * angle), d = std::sin(2 * angle);
  return {mean - half * c - s[2] * d, s[2] * c - half * d};
}

/// Upper limit of the divided strength in the program of the lower bound, in units of stress: a block of steel beside
/// soil without cohesion would leave the soil below the tolerance of the solver. The limit is safe, as a field that is
/// admissible in weaker soil is so in stronger soil too.
inline constexpr double most_strength = 30;
/// Cohesion, in units of stress, above which the soil of a triangle moves as a rigid body in the upper bound. The limit
/// is safe, as a restriction of the velocities does not lower the upper bound.
inline constexpr double rigid_strength = 100;

inline bool is_rigid(const std::array<Strength, 3>& corners, const Units& units) {
  return std::all_of(corners.begin(), corners.end(), [&](const Strength& s) {
    const double least = rigid_strength * units.stress;
    return s.cohesion >= least && (!s.tension || *s.tension >= least) && (!s.planes || s.planes->cohesion >= least);
  });
}

/// Returns the largest F with R √(1 + tan²φ/F²) ≤ c/F − σ'_m tan φ/F, that is F² ≤ ((c − σ'_m tan φ)/R)² − tan²φ
/// (T21.3), R + σ'_m ≤ tension/F, and |τ| ≤ (c − σ' tan φ)/F on weak planes; 0 if no F is small enough, infinity
/// without shear. Soil that is not reduced allows any F or none.
inline double find_factor(const Strength& soil, const Stress& effective) {
  const Circle circle = find_circle(effective);
  constexpr double any = std::numeric_limits<double>::infinity();
  if (!std::isfinite(circle.radius) || !std::isfinite(circle.mean)) return 0;
  double factor = any;
  soil.visit_lines([&](double more_cohesion, double tangent) {
    const double available = soil.cohesion + more_cohesion - circle.mean * tangent;
    if (circle.radius > 0) {
      const double ratio = available / circle.radius;
      factor = std::min(factor, ratio > tangent ? std::sqrt((ratio - tangent) * (ratio + tangent)) : 0);
    } else if (available < 0) {
      factor = 0;
    }
  });
  if (soil.tension && circle.radius + circle.mean > 0)
    factor = std::min(factor, *soil.tension / (circle.radius + circle.mean));
  if (soil.planes) {
    const PlaneTraction on = find_plane_traction(effective, soil.planes->angle);
    const double available = soil.planes->cohesion - on.normal * soil.planes->tan_friction;
    if (on.shear != 0 || available < 0) factor = std::min(factor, available > 0 ? available / std::abs(on.shear) : 0);
  }
  if (!soil.is_reduced) return factor >= 1 ? any : 0;
  return factor;
}

// Edges of a triangulation, with the triangles on both sides.

/// An edge by its two nodes, the smaller number first.
using EdgeKey = std::pair<int, int>;
inline EdgeKey make_key(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

struct Edge {
  int from = 0, to = 0;        ///< its nodes, counterclockwise in `triangle`
  int triangle = 0, side = 0;  ///< the edge runs from corner `side` of `triangle` to the next
  int other = -1;              ///< triangle on the other side; -1: the border
};

/// Edges of the walls of a section.
class WallKeys {
 public:
  explicit WallKeys(const Problem& problem) {
    for (const Wall& wall : problem.walls)
      for (std::size_t i = 0; i < wall.size(); ++i) keys_.insert(make_key(wall.nodes[i], wall.nodes[i + 1]));
  }
  bool contains(int a, int b) const { return keys_.contains(make_key(a, b)); }

 private:
  std::set<EdgeKey> keys_;
};

/// Returns the edges in the order in which the triangles first have them.
inline std::vector<Edge> list_edges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  std::map<EdgeKey, std::size_t> known;
  for (std::size_t e = 0; e < triangles.size(); ++e)
    for (int i = 0; i < 3; ++i) {
      const int a = triangles[e][static_cast<std::size_t>(i)], b = triangles[e][static_cast<std::size_t>((i + 1) % 3)];
      const auto [at, is_new] = known.try_emplace(make_key(a, b), edges.size());
      if (is_new) {
        edges.push_back({a, b, static_cast<int>(e), i, -1});
      } else {
        edges[at->second].other = static_cast<int>(e);
      }
    }
  return edges;
}

/// Returns the index of a node among the corners of a triangle.
inline std::size_t find_corner(const Triangle& triangle, int node) {
  return triangle[0] == node ? 0 : triangle[1] == node ? 1 : 2;
}

}  // namespace talus::bounds
