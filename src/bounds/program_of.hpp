// SPDX-License-Identifier: MIT
#pragma once
// The two cone programs of a problem. Unknown are the effective stresses at the corners of the triangles, three each,
// and last the cohesion m that every corner lacks: the least m with which there is equilibrium under all loads. The
// slope stands with strengths divided by F where m ≤ 0. (A multiplier of gravity, as in the literature, has no value in
// soil without cohesion; m has one always.)

#include <map>

#include "bounds/conic/program.hpp"
#include "bounds/problem.hpp"

namespace talus::bounds {

struct Units {
  double length = 1;  ///< [m]
  double stress = 1;  ///< [Pa]
};

/// Numbers of about one: the extent of the section, and the largest weight over it with the largest load.
Units find_units(const Problem& problem);

enum class Bound {
  lower,  ///< stresses linear in each triangle, in equilibrium inside, across every edge and with the loads: a field
          ///< that holds
  upper   ///< equilibrium with every quadratic field of velocities on six-node triangles: its multipliers are such a
          ///< field, and the strength is needed at the corners of the triangles only
};

ConicProgram make_program(const Problem& problem, Bound bound, double factor, const Units& units);

/// Asks for multipliers of the cones that are inside them by `room`: with what the solver leaves of its equations they
/// still are inside.
void leave_room(ConicProgram& program, double room);

/// Adds the room to the multipliers of a solution of the changed program. Returns the lack that they prove of the
/// unchanged one.
double use_room(const ConicProgram& program, double room, ConicSolution& solution);

/// The derivative of the least m by the factor, at a solution of that program.
double find_lack_rate(const Problem& problem, Bound bound, double factor, const Units& units,
                      const ConicSolution& solution);

/// Numbers of the velocities that the equations of the upper bound belong to.
struct Velocities {
  std::vector<Vec<2>> nodes;                  ///< corners, then middles of edges
  std::vector<std::array<int, 6>> triangles;  ///< corners, then the middles after them (0–1, 1–2, 2–0)
  /// Of each node the directions in which it may move, with their numbers; none where it is held.
  struct Freedom {
    Vec<2> direction;
    int number;
  };
  std::vector<std::vector<Freedom>> freedoms;
  std::map<std::pair<int, int>, int> middles;  ///< of the edges, by the smaller and the larger of their corners
  int count = 0;
};
Velocities number_velocities(const Problem& problem);

}  // namespace talus::bounds
