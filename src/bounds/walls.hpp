// SPDX-License-Identifier: MIT
#pragma once
// Walls in limit analysis: rigid-plastic beams along edges of the mesh, from which the soil of either side may slip and
// lift off. Values are per metre of slope.

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "base/vec.hpp"

namespace talus::bounds {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Strength of the soil at the face of a wall, which F divides: |τ| ≤ c − σ' tan φ, and no effective tension.
struct InterfaceStrength {
  double cohesion = 0;  ///< the least on the edge [Pa]
  double tan_friction = 0;
  double more_cohesion = 0;  ///< the largest on the edge over the least, for the upper bound [Pa]

  InterfaceStrength find_largest() const { return {cohesion + more_cohesion, tan_friction}; }
};

/// A horizontal prop beside a node of a wall, in compression only.
struct Strut {
  int node = 0;    ///< of the mesh
  double way = 1;  ///< 1: it stands on the side of growing x, and the wall shortens it by moving there; −1
  double strength = unlimited;  ///< [N]
};

/// A beam with hinges where its moment reaches the plastic one. With finite axial strength and moment both,
/// |N|/N_p + |M|/M_p ≤ 1.
struct Wall {
  std::vector<int> nodes;                                   ///< of the mesh, from head to toe
  std::vector<std::array<InterfaceStrength, 2>> interface;  ///< of each edge, to the soil at its left and right
  double moment = unlimited;                                ///< M_p [N m]
  double axial = unlimited;                                 ///< N_p [N]
  double shear = unlimited;                                 ///< [N]
  Vec<2> line_load{};                                       ///< force per metre of wall [Pa]
  std::vector<Strut> struts;

  std::size_t size() const { return interface.size(); }  ///< edges
};

/// The soil at one side of an edge of a wall: a triangle, and its corners at the upper and the lower end.
struct WallFace {
  std::size_t triangle = 0;
  std::array<std::size_t, 2> corner{};
};

struct WallEdge {
  std::array<int, 2> node{};                    ///< upper and lower end
  double length = 0;                            ///< [m]
  Vec<2> along{}, normal{};                     ///< from the upper to the lower end, and to its left
  std::array<std::optional<WallFace>, 2> face;  ///< left and right; none in the air
  std::array<Vec<2>, 2> load{};                 ///< surface load on a side without soil, at both ends [Pa]
};

/// The largest force of the head of a bar on a wall.
struct WallForce {
  std::size_t node = 0;  ///< index among the nodes of the wall
  Vec<2> force{};        ///< at factor 1 [N]
  bool is_reduced = false;
  std::size_t bar = 0;

  double find_divisor(double factor) const { return is_reduced ? factor : 1; }
};

struct Problem;

/// Returns false if two walls share an edge, a strut or the head of a bar lies beside its wall, a bar or its head on an
/// edge of a wall, or a wall on a fixed side: certificates do not cover that.
bool are_walls_sound(const Problem& problem);
/// Returns the edges of each wall.
std::vector<std::vector<WallEdge>> list_wall_edges(const Problem& problem);
/// Returns the forces of bars on each wall.
std::vector<std::vector<WallForce>> list_wall_forces(const Problem& problem);
/// Returns the index of a node among those of a wall.
std::size_t find_wall_node(const Wall& wall, int node);

}  // namespace talus::bounds
