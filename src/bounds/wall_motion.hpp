// SPDX-License-Identifier: MIT
#pragma once
// Motions of walls in the upper bound, and their contacts with the soil.

#include <utility>
#include <vector>

#include "bounds/problem.hpp"
#include "bounds/velocities.hpp"

namespace talus::bounds {

/// Gives the triangles around each node of a wall that only edges of walls connect nodes of their own, which are copies
/// of it at the end of `nodes`.
void separate_at_walls(const Problem& problem, const std::vector<Edge>& edges,
                       std::vector<std::array<int, 6>>& triangles, std::vector<Vec<2>>& nodes);

/// Numbers the motions of the walls. Two restrictions do not lower the upper bound: the toe of a wall in soil moves
/// with the soil there, which has one velocity, and the lower part of a wall between rigid soil of one body is clamped.
void number_walls(const Problem& problem, const Units& units, Velocities& v);

/// Returns the component along `direction` of a velocity.
MotionForm find_component(const std::vector<Freedom>& freedoms, const Vec<2>& direction, double times = 1);
/// Adds `times` a form.
void add_form(MotionForm& sum, const MotionForm& form, double times = 1);

/// A place where soil and wall touch: one of the three Bézier points of their relative velocity on an edge. Between
/// them the relative velocity is a mean of theirs, so that the flow rule holds everywhere if it holds there, and the
/// sum of their dissipation, which is convex, is not less than that of the edge.
struct Contact {
  std::size_t wall = 0;
  InterfaceStrength strength;
  double weight = 0;    ///< a third of the length of the edge [m]
  double pressure = 0;  ///< mean pore pressure with the weight of the point [Pa]
  MotionForm opening;   ///< velocity of the soil away from the wall
  MotionForm slip;      ///< along it
};

/// Returns the contacts of all walls; those that do not move are left out.
std::vector<Contact> list_contacts(const Problem& problem, const Velocities& v);

/// Returns the shortening of the struts of a wall.
std::vector<MotionForm> list_shortenings(const Wall& wall, const WallMotion& motion);

/// Returns the velocity of a wall at one of its nodes, of the part below.
const std::vector<Freedom>& find_wall_velocity(const WallMotion& motion, std::size_t node);

/// A limit of an opening field beside the soil: `opening` ≥ tan_friction |slip| at a contact, and no shortening of a
/// strut that does not yield.
struct OpeningLimit {
  MotionForm opening, slip;
  double tan_friction = 0;
};
std::vector<OpeningLimit> list_opening_limits(const Problem& problem, const Velocities& v);

/// Evaluates a form.
double evaluate(const MotionForm& form, const std::vector<double>& numbers);

}  // namespace talus::bounds
