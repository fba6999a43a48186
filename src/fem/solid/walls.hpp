// SPDX-License-Identifier: MIT
#pragma once
// Walls in plane soil: beams along edges of the mesh, whose nodes are doubled, with an interface to the soil on either
// side. docs/theory/19-finite-elements.md has the equations.

#include <functional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "fem/solid/bars.hpp"

namespace talus::fem {

/// Strength of an interface: adhesion + friction × compression.
struct InterfaceStrength {
  double adhesion = 0;  ///< [Pa]
  double friction = 0;  ///< tan δ [-]
};

/// A horizontal prop on the side of a wall without soil, whose far end does not move.
struct Strut {
  double level = 0;             ///< [m]
  double stiffness = 0;         ///< [N/m]
  double strength = unlimited;  ///< in compression [N]; in tension it has none
  double prestress = 0;         ///< compression at which it is locked off [N]
};

/// A beam with interfaces; all values are per metre of slope. With finite strengths N_p and M_p both, its axial force
/// and moment interact (T19.16).
struct Wall {
  std::string name;
  std::vector<int> nodes;        ///< of the linear mesh from head to toe; neighbours are ends of an edge of the mesh
  double axial_stiffness = 0;    ///< E A [N]
  double axial = unlimited;      ///< axial strength in tension and compression [N]
  double bending_stiffness = 0;  ///< E I [N m²]
  double shear_stiffness = 0;    ///< κ G A [N]
  double moment = unlimited;     ///< plastic moment [N m]
  double shear = unlimited;      ///< shear strength [N]
  double normal_stiffness = 0, tangential_stiffness = 0;  ///< of the interfaces [Pa/m]
  /// Strength of the interface to the soil of a region of the mesh, which the factor divides; empty: rough.
  std::function<InterfaceStrength(int region, const Vec<2>& x)> interface;
  std::vector<Strut> struts;
  Vec<2> line_load{};  ///< force per metre of wall, as of its weight [Pa]
};

}  // namespace talus::fem
