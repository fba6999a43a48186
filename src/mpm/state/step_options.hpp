// SPDX-License-Identifier: MIT
#pragma once
// Options of one step, and the lists of points that leave their element in it.

#include <vector>

#include "base/vec.hpp"
#include "input/case/case.hpp"

namespace talus::mpm {

template <int D>
struct StepOptions {
  double dt = 0;            ///< [s]
  Vec<D> gravity{};         ///< [m/s²]
  double damping = 0;       ///< α of (2.89)
  double mass_scaling = 1;  ///< β of (2.91)
  bool mixed = false;       ///< mixed integration (2.92-2.93)
  input::Smoothing smoothing = input::Smoothing::none;
  bool moving = true;     ///< false: frozen geometry, small strain
  bool objective = true;  ///< rotate stresses with the soil
  bool monitor = false;   ///< fill Body::monitor in this step
  int threads = 1;
  // The options below are for soil with pore water.
  bool darcy = false;                ///< Darcy (u-p) formulation: one velocity, pressures at the nodes (darcy_step.hpp)
  double pressure_tolerance = 1e-5;  ///< residual of the pressure equation over its right-hand side [-]
  bool implicit_drag = true;
  double water_damping = 0;  ///< α of (2.89) for the water
  bool net_damping = true;  ///< damp the net force, drag and skin included (T14.10); false: without drag, as the source
  bool smooth_pressure = false;    ///< (2.96-2.97)
  bool exchange_water = false;     ///< between elements, against spurious pressure modes (T14.9)
  double conductivity_factor = 1;  ///< factor on k [-]
};

/// Points of one slot of a block that left their element in advance_points(); input of relocate().
struct Mover {
  int block, slot;
  unsigned lanes;  ///< bit set of the lanes concerned
};
using MoverLists = std::vector<std::vector<Mover>>;  ///< by chunk

}  // namespace talus::mpm
