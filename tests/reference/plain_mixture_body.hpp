// SPDX-License-Identifier: MIT
#pragma once
// The data of the plain step of the Darcy (u–p) formulation: one velocity of soil and water, nodal pore pressures, and
// Darcy's flux eliminated. The equations are in docs/theory/22-mixture.md.

#include <utility>
#include <vector>

#include "reference/plain_two_phase_body.hpp"

namespace talus::reference {

struct DarcySettings : WetSettings {
  double projection = 1;  ///< τ of (T22.8) times E_c/2 [-]
};

/// Water of a node during one step. Volumes are those of water at zero pressure.
struct WaterNode {
  double pores = 0;    ///< P_i [m³]; 0: no pore water is near
  double water = 0;    ///< W_i [m³]
  double held = 0;     ///< what the pores hold at the pressure of the start of the step [m³]
  double storage = 0;  ///< −dH/dp of the water content H [m³/Pa]
  double change = 0;   ///< δ: what the step adds to the pressure [Pa]
  double out = 0;      ///< what leaves the node in the step, to other nodes and through the surface [m³]
  double offered = 0;  ///< inflow that the surface offers [m³/s]
  double passed = 0;   ///< and what of it passes the surface [m³]
  bool fixed = false;  ///< the surface holds its pressure
};

/// Pores of one soil at a node.
struct SoilPores {
  const PoreWater* soil;
  double pores;  ///< [m³]
};

template <int D>
struct DarcyBody : WetBody<D> {
  DarcyBody() = default;
  explicit DarcyBody(WetBody<D> body) : WetBody<D>(std::move(body)) {}

  // By node. The pressure stays from step to step; NaN where there was no water.
  std::vector<double> pressure;  ///< tension positive [Pa]
  std::vector<bool> ponded;     ///< water is ponded on the surface: rain does not infiltrate at once, or seepage leaves
  std::vector<double> own;      ///< nodal remainder: water beside the fraction of that of the elements [m³]
  std::vector<Vector<D>> area;  ///< of the open sides that touch the node, outwards [m²]
  // By node, of the last step.
  std::vector<WaterNode> water;
  std::vector<std::vector<SoilPores>> soils_at;
};

}  // namespace talus::reference
