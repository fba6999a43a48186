// SPDX-License-Identifier: MIT
#pragma once
// Uptake of pore water by plant roots (docs/theory/16-season.md).

#include <string>
#include <vector>

#include "base/lane.hpp"
#include "input/language/time_table.hpp"
#include "material/water/feddes.hpp"

namespace talus::mpm {

template <int D>
struct Body;
template <int D>
struct StepOptions;

/// Plants that draw water through the points of their root zone. A point loses α(s) T(t) times its weight.
struct RootUptake {
  std::string name;
  input::TimeTable rate;       ///< T, potential per horizontal area of ground [m/s]
  material::Feddes reduction;  ///< α, of the element's mean suction
  /// By point number: horizontal ground area whose transpiration is drawn from the point [m²] (2D: m). It moves with
  /// the point and is lost with it.
  std::vector<double> weight;
};

/// Adds the root uptake until the next call to the water's surplus, which the next pass removes from the points, and to
/// Water::transpired. Does nothing while the geometry is frozen.
template <int D>
void draw_root_water(Body<D>& body, const StepOptions<D>& options);

/// The same for the Darcy step, in every step: writes water.darcy.drawn [m³] and adds to Water::transpired.
template <int D>
void find_root_draw(Body<D>& body, const StepOptions<D>& options);

}  // namespace talus::mpm
