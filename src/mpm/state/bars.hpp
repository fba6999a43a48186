// SPDX-License-Identifier: MIT
#pragma once
// Bars in the soil of a body: nails, anchors, bolts and geosynthetics (theory 25). A bar is a chain of pieces that
// carry tension; bond joins its nodes to the soil around them, through which they move. Its own mass is neglected, so
// in each step the bar is in equilibrium with the bond. Values are per metre of slope.

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "base/spring.hpp"
#include "base/vec.hpp"
#include "mpm/state/soil_place.hpp"

namespace talus::mpm {

struct BarNode {
  double place = 0;  ///< distance from the head along the bar as it was installed [m]
  SoilPlace soil;
  SpringLaw bond;       ///< over the length that the node stands for; its deformation is the slip [m]
  double slip = 0;      ///< elastic slip of the bar in the soil, towards its end [m]
  double all_slip = 0;  ///< [m]
  Vec<2> force{};       ///< of the bar on the soil [N]
};

struct BarPiece {
  double length = 0;   ///< as installed [m]
  double strain = 0;   ///< elastic [-]
  double plastic = 0;  ///< [-]
  double tension = 0;  ///< [N]
  bool is_torn = false;
};

/// Plate or facing, which presses on the ground around the head.
struct BarPlate {
  std::vector<SoilPlace> places;  ///< carried by the points under them
  SpringLaw law;
  double elastic = 0;  ///< [m]
  double force = 0;    ///< [N]
  Vec<2> push{};       ///< the force on the soil [N]
};

struct Bar {
  std::string name;            ///< of the support in the case
  Vec<2> head{}, end{};        ///< as installed [m]
  std::vector<BarNode> nodes;  ///< from the head to the end
  std::vector<BarPiece> pieces;
  SpringLaw tension;                                                ///< of a piece; its deformation is the strain
  double rupture_strain = std::numeric_limits<double>::infinity();  ///< plastic strain at which a piece tears [-]
  double prestress = 0;                                             ///< of the first piece [N]
  BarPlate plate;
  bool reduces_bond = false;  ///< divides the bond by the factor of a trial
  double divisor = 1;         ///< of the bond
};

/// Joins the bars to the soil by the present nodal sums and points. A head that touches no soil follows the ground
/// under its plate.
void join_bars(Body<2>& body);

/// Joins the bars to the soil, and adds their forces on it to the loads of the nodes.
void add_bar_forces(Body<2>& body);

/// Indices of the joined nodes of a bar around each node, with their weights: the node itself if it is joined.
struct JoinedNodes {
  std::array<int, 2> node{};
  std::array<double, 2> weight{};
};
/// Returns them for each node; empty if no node is joined.
std::vector<JoinedNodes> find_joined(const Bar& bar);

/// Largest of the stiffness of the bars at a node over its mass [1/s²], which bounds the time step; 0 without bars.
double find_bar_rate(const Body<2>& body);

}  // namespace talus::mpm
