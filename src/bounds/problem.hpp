// SPDX-License-Identifier: MIT
#pragma once
// A section as limit analysis sees it: triangles with strength, weight, pore pressures, loads and supports. Plane
// strain; lengths in metres, x to the right, y up. Stress is positive in tension: xx, yy, xy. Pore pressure is positive
// in compression.

#include <array>
#include <optional>
#include <vector>

#include "base/vec.hpp"

namespace talus::bounds {

using Triangle = std::array<int, 3>;
/// xx, yy, xy [Pa]
using Stress = std::array<double, 3>;

/// Of the soil at a corner of a triangle: |t| ≤ c − σ' tan φ on every plane, and no effective tension above `tension`.
struct Strength {
  double cohesion = 0;            ///< c [Pa]
  double tan_friction = 0;        ///< tan φ
  std::optional<double> tension;  ///< largest effective tension, divided as c and tan φ are [Pa]
};

/// An edge of the border of the soil.
struct Side {
  int from = 0, to = 0;  ///< its nodes
  bool holds_normal = false, holds_along = false;
  std::array<Vec<2>, 2> traction{};  ///< on the mixture, at `from` and `to` [Pa]; taken where it is not held
};

struct Problem {
  std::vector<Vec<2>> nodes;
  std::vector<Triangle> triangles;                   ///< counterclockwise
  std::vector<int> region;                           ///< of each triangle
  std::vector<std::array<Strength, 3>> strength;     ///< at its corners, linear between them
  std::vector<Vec<2>> body_force;                    ///< of each triangle, with its water [N/m³]
  std::vector<std::array<double, 3>> pore_pressure;  ///< at its corners, linear between them [Pa]
  std::vector<Side> sides;                           ///< all of the border; a side that is not named is free

  std::size_t size() const { return triangles.size(); }
};

/// Twice the area, and the gradients of the three corners' shape functions [1/m].
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

/// Gradients of the six quadratic shape functions (corners, then middles of 0–1, 1–2, 2–0) at corner c [1/m].
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

struct Units {
  double length = 1;  ///< [m]
  double stress = 1;  ///< [Pa]
};

/// Numbers of about one: the height of the section, and the largest weight over it or load.
Units find_units(const Problem& problem);

}  // namespace talus::bounds
