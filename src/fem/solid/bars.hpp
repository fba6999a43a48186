// SPDX-License-Identifier: MIT
#pragma once
// Straight bars and beams in plane soil: nails, anchors, bolts, geosynthetics, piles and plates. The elements of the
// mesh need not conform to them. docs/theory/19-finite-elements.md has the equations.

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/vec.hpp"

namespace talus::fem {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// A bar (forces along its axis only) or, with bending stiffness, a beam. All values are per metre of slope. Along the
/// bar the soil is joined to it by bond, and across a beam by lateral springs; across a bar without bending stiffness
/// the soil is free.
struct Bar {
  std::string name;
  Vec<2> head{}, end{};          ///< [m]
  double axial_stiffness = 0;    ///< E A [N]
  double tensile = unlimited;    ///< tensile strength [N]
  double compressive = 0;        ///< compressive strength [N]; 0: the bar goes slack
  double bending_stiffness = 0;  ///< E I [N m²]; 0: no beam
  double shear_stiffness = 0;    ///< κ G A of a beam [N]
  double moment = unlimited;     ///< plastic moment of a beam [N m]
  double shear = unlimited;      ///< shear strength of a beam [N]
  double free_length = 0;        ///< length from the head without bond; bars only [m]
  double prestress = 0;          ///< force at which the free length is locked off [N]
  double bond_stiffness = 0;     ///< bond per metre and slip [Pa/m]
  double lateral_stiffness = 0;  ///< of the springs across a beam [Pa/m]
  bool reduces_bond = false;     ///< divides bond and lateral resistance by the factor of the trial
  /// Bond strength per metre of bar at a point [Pa]; empty: unlimited.
  std::function<double(const Vec<2>& x)> bond;
  /// Resistance of the soil across a beam per metre at a point [Pa]; empty: unlimited.
  std::function<double(const Vec<2>& x)> lateral;
  double plate = 0;                ///< strength of the plate or facing at the head [N]; 0: none
  double plate_stiffness = 0;      ///< [N/m]
  std::vector<Vec<2>> plate_line;  ///< ground under the plate as a polyline [m]; empty: the head alone
  int wall = -1;                   ///< index of the wall that the plate presses on, in place of the soil; -1: none
  double anchorage = 0;            ///< strength of the anchorage at the end point [N]; 0: none
  double anchorage_stiffness = 0;  ///< [N/m]
  Vec<2> head_load{};              ///< force on the head [N]
  Vec<2> line_load{};              ///< force per metre of bar [Pa]; a bar carries its part along the axis
};

/// A quantity along a bar.
struct BarCurve {
  std::vector<double> place;  ///< distance from the head [m]
  std::vector<double> value;
  std::vector<double> limit;  ///< strength at the place
};

/// Stress between a wall and the soil on one of its sides.
struct FacePoint {
  double place = 0;                ///< distance from the head [m]
  double normal = 0;               ///< effective, positive in compression [Pa]
  double shear = 0, strength = 0;  ///< shear stress of the soil on the wall, towards its toe, and its limit [Pa]
};

/// Forces of a bar in a state, tension positive.
struct BarForces {
  BarCurve axial;                                    ///< [N]
  BarCurve bond;                                     ///< force of the soil on the bar towards its end, per metre [Pa]
  BarCurve shear;                                    ///< [N]; beams
  BarCurve moment;                                   ///< [N m]; beams
  BarCurve lateral;                                  ///< force of the soil on the beam across it, per metre [Pa]; beams
  double plate = 0, plate_limit = 0, anchorage = 0;  ///< [N]
  double energy = 0;                                 ///< elastic energy of bar, bond, plate and anchorage [J]
  std::array<std::vector<FacePoint>, 2> face;        ///< of walls: soil at the left and at the right, from the head
  BarCurve strut;                                    ///< of walls: compression [N]
  BarCurve deflection;  ///< of walls beside soil: displacement towards the left of the way from head to toe [m]
};

}  // namespace talus::fem
