// SPDX-License-Identifier: MIT
#pragma once
// The velocities of the upper bound: nodes of quadratic triangles, and the directions in which each may move.

#include <map>
#include <optional>
#include <vector>

#include "bounds/conic/cones.hpp"
#include "bounds/problem.hpp"

namespace talus::bounds {

struct Velocities {
  std::vector<Vec<2>> nodes;                  ///< corners, then middles of edges
  std::vector<std::array<int, 6>> triangles;  ///< corners, then the middles after them (0–1, 1–2, 2–0)
  /// Of each node the directions in which it may move, with their numbers; none where it is held. The nodes of a rigid
  /// body share its translations and its rotation.
  struct Freedom {
    Vec<2> direction;
    int number;
  };
  std::vector<std::vector<Freedom>> freedoms;
  std::map<EdgeKey, int> middles;  ///< of the edges
  int count = 0;
};

/// Every velocity that supports leave free has a number. Touching rigid triangles (is_rigid()) are one body; one that
/// is held in one direction alone moves across it without turning, and one that is held otherwise does not move.
Velocities number_velocities(const Problem& problem, const Units& units);

// Velocities that open the soil: a little of them takes back what rounding leaves of the flow rule.

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

// From nearly to exactly: equations that a solver fulfils to its tolerance, fulfilled to rounding.

/// The least change of x (weighted sum of squares) with A x = b, for the first `rows` rows of A: [W Aᵀ; A −δ] again and
/// again, which takes δ's effect away. Rows may repeat one another. No weights are weights of one.
void fulfil(const SparseRows& a, int rows, const std::vector<double>& right, std::vector<double>& x,
            const std::vector<double>& weights = {});

}  // namespace talus::bounds
