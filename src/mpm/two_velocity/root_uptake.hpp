// SPDX-License-Identifier: MIT
#pragma once
// Water that the roots of plants draw from the pores (docs/theory/16-season.md).

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

/// Plants that draw water through the points where their roots are. A point loses α(s) T(t) of its weight.
struct RootUptake {
  std::string name;
  input::TimeTable rate;       ///< T, potential per horizontal area of ground [m/s]
  material::Feddes reduction;  ///< α, of the mean suction of the element
  /// By point number: the ground, measured on the horizontal, that drinks through the point [m²] (2D: m). Goes with the
  /// point, and with it is lost.
  std::vector<double> weight;
};

/// Adds to the water's surplus, which the next pass takes from the points, what roots draw until the surplus is found
/// again, and counts it in Water::transpired. Nothing while the geometry is frozen.
template <int D>
void draw_root_water(Body<D>& body, const StepOptions<D>& options);

/// The same for the step of the mixture, in every step: writes water.mixture.drawn [m³] and counts Water::transpired.
template <int D>
void find_root_draw(Body<D>& body, const StepOptions<D>& options);

}  // namespace talus::mpm
