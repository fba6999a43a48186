// SPDX-License-Identifier: MIT
#pragma once
// The velocities of the upper bound: nodes of quadratic triangles, their degrees of freedom, and fields that open the
// soil.

#include <map>
#include <optional>
#include <vector>

#include "bounds/conic/cones.hpp"
#include "bounds/flow_rule.hpp"
#include "bounds/problem.hpp"

namespace talus::bounds {

/// Coefficients of degrees of freedom, by increasing number.
using MotionForm = std::vector<std::pair<int, double>>;

/// A direction in which a node may move, with the number of the degree of freedom.
struct Freedom {
  Vec<2> direction;
  int number;
};

/// The motion of a wall: rigid edges, and hinges between them.
struct WallMotion {
  std::vector<std::array<std::vector<Freedom>, 2>> ends;  ///< of each edge: velocities of its upper and lower end
  std::vector<MotionForm> rotation;                       ///< of each edge, times the length of the section
  std::size_t free = 0;                                   ///< edges from the head on that are not clamped
  /// Numbers of the velocities of the upper part relative to the lower one at each node between two edges, along and
  /// across the upper edge; −1: none.
  std::vector<std::array<int, 2>> jump;
};

struct Velocities {
  std::vector<Vec<2>> nodes;                  ///< corners, those that walls double, then middles of edges
  std::vector<std::array<int, 6>> triangles;  ///< corners, then the middles of 0–1, 1–2, 2–0
  /// Degrees of freedom of each node. A fixed node has none, and those of a rigid body share its translations and its
  /// rotation.
  std::vector<std::vector<Freedom>> freedoms;
  /// Nodes of each edge of the problem: at its node of the smaller number, in the middle, at the other.
  std::map<EdgeKey, std::array<int, 3>> edges;
  std::vector<WallMotion> walls;
  int count = 0;

  /// Returns the nodes of an edge, in this direction. At a wall only those of one side.
  std::array<int, 3> find_nodes(int from, int to) const {
    const std::array<int, 3>& own = edges.at(make_key(from, to));
    return from < to ? own : std::array<int, 3>{own[2], own[1], own[0]};
  }
};

/// Numbers the degrees of freedom that the supports leave. Triangles on both sides of a wall have nodes of their own.
/// Adjoining rigid triangles (is_rigid()) form one body: one that is fixed in a single direction moves across it
/// without rotation, and one that is fixed otherwise does not move.
Velocities number_velocities(const Problem& problem, const Units& units);

/// Returns the problem with rigid triangles where fixed edges meet at less than 2 φ_F: a velocity that vanishes on both
/// cannot dilate between them as the flow rule requires, so that the soil is at rest there, and a mechanism with it at
/// rest proves an upper bound of the given problem. Nothing is returned where there is no such corner.
std::optional<Problem> hold_narrow_corners(const Problem& problem, double factor, const Units& units);

// Fields that open the soil. A small multiple of one restores the flow rule where rounding violates it.

/// Returns the strain rates of the corners, three of each triangle, for the velocities `numbers`.
std::vector<Strain> find_strains(const Problem& problem, const Velocities& mesh, const std::vector<double>& numbers);

/// Returns true if a corner may open. Soil without friction and tension cut-off keeps its volume, and rigid soil its
/// shape.
inline bool may_open(const Problem& problem, std::size_t e, std::size_t c, const Units& units) {
  const Strength& soil = problem.strength[e][c];
  return (soil.tan_friction > 0 || soil.tension.has_value()) && !is_rigid(problem.strength[e], units);
}

/// Returns the corners, three of each triangle, that may open and can strain: where one triangle fills the corner
/// between two fixed sides, it strains there in no field, and satisfies every flow rule.
std::vector<bool> find_opening_corners(const Problem& problem, const Velocities& mesh);

/// Returns the rows of div u = 0 at the corners that may not open, times the length of the section.
SparseRows list_openings(const Problem& problem, const Velocities& mesh, double length);

/// Velocity field of one mesh with ε_v > sin φ √((ε_x − ε_y)² + γ²) at every corner that may open and can strain, and
/// ε_v = 0 at the others, whatever slips on weak planes: the lifting field, or, where supports or other soil do not
/// permit that, the field of the largest margin.
class OpeningSearch {
 public:
  /// Returns the velocities by degree of freedom; nullptr if there are none. Those of an earlier factor are reused if
  /// they suffice, since a larger factor requires less dilation.
  const std::vector<double>* find(const Problem& problem, const Velocities& mesh, double factor, double length);
  /// Discards the field after a change of mesh.
  void forget() { found_.reset(); }

 private:
  std::optional<std::vector<double>> found_;
};

// Correction of equations that a solver satisfies within its tolerance, so that they hold to rounding.

/// Applies the smallest change of x (weighted sum of squares) with A x = b, for the first `rows` rows of A, by repeated
/// solution with [W Aᵀ; A −δ], which removes the effect of δ. Rows may be redundant. Without `weights` all are one.
void fulfil(const SparseRows& a, int rows, const std::vector<double>& right, std::vector<double>& x,
            const std::vector<double>& weights = {});

}  // namespace talus::bounds
