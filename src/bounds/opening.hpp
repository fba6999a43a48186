// SPDX-License-Identifier: MIT
#pragma once
// Velocities that open the soil: a little of them takes back what rounding leaves of the flow rule.

#include <optional>

#include "bounds/conic/program.hpp"
#include "bounds/strength.hpp"
#include "bounds/velocities.hpp"

namespace talus::bounds {

/// At a corner of a triangle: ε_v, and √((ε_x − ε_y)² + γ²) [1/m per unit of velocity].
struct Strain {
  double opening = 0, shear = 0;
};

/// Of the corners, three of each triangle, under the velocities with these numbers.
std::vector<Strain> find_strains(const Problem& problem, const Velocities& mesh, const std::vector<double>& numbers);

/// Soil without friction and without a largest tension keeps its volume, and rigid soil keeps its shape: only the other
/// corners may open.
inline bool may_open(const Problem& problem, std::size_t e, std::size_t c, const Units& units) {
  const Strength& soil = problem.strength[e][c];
  return (soil.tan_friction > 0 || soil.tension.has_value()) && !is_rigid(problem.strength[e], units);
}

/// sin φ with tan φ divided by the factor.
double find_sine(const Strength& soil, double factor);

/// Rows of div u = 0 at the corners that may not open, times the length of the section.
SparseRows list_openings(const Problem& problem, const Velocities& mesh, double length);

/// Velocities of one mesh with ε_v > sin φ √((ε_x − ε_y)² + γ²) at every corner that may open, and ε_v = 0 at the
/// others: lifting the soil by its height above the lowest node, or, where supports or other soil forbid that, the
/// field of the largest margin.
class OpeningSearch {
 public:
  /// Numbers of the velocities; nothing where there are none. Those of an earlier factor are kept where they suffice: a
  /// larger factor asks for less.
  const std::vector<double>* find(const Problem& problem, const Velocities& mesh, double factor, double length);
  /// The mesh is another one now.
  void forget() { found_.reset(); }

 private:
  std::optional<std::vector<double>> found_;
};

}  // namespace talus::bounds
