// SPDX-License-Identifier: MIT
#pragma once
// Water that roots draw from the soil: a sink in the nodal equations of seepage (T16.1).

#include <string>
#include <vector>

#include "input/language/time_table.hpp"
#include "material/water/feddes.hpp"

namespace talus::fem {

/// Plants that draw water where their roots are. Node i loses α(s_i) T(t) W_i.
struct RootSink {
  std::string name;
  material::Feddes reduction;   ///< α
  input::TimeTable rate;        ///< T, potential per horizontal area of ground [m/s]
  std::vector<double> weights;  ///< W per node of the mesh: the roots' share times the ground covered [m²] (2D: m)
};

/// Water drawn through one sink [m³/s] (per metre of thickness in 2D); for a time range [m³].
struct Uptake {
  std::string name;
  double potential = 0;  ///< potential transpiration
  double actual = 0;     ///< actual transpiration
};

}  // namespace talus::fem
