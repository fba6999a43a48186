// SPDX-License-Identifier: MIT
#pragma once
// Resistance of bars along their length: bond from overburden and pore pressure, and the pressure of soil that flows
// between piles.

#include <vector>

#include "lem/section/section.hpp"
#include "lem/section/slope.hpp"

namespace talus::lem {

/// Resistance of a bar that is summed from its head: pull-out by bond, or the pressure of flowing soil [N/m].
struct BarDiagram {
  double from = 0, step = 1;  ///< first station, distance of the stations [m]
  std::vector<double> sum;    ///< at the stations; zero before the first

  /// Returns the resistance of the part between two distances from the head [N/m].
  double find_part(double begin, double end) const { return at(end) - at(begin); }

 private:
  double at(double s) const;
};

/// Sums the resistance of a bar, with σ'_v of the slope along it.
BarDiagram make_bar_diagram(const Slope& slope, const Bar& bar);

/// Returns the lateral force per metre of its length of soil that flows plastically between piles, on one pile [N/m]
/// (Ito and Matsui 1975): c [Pa], φ [rad] and σ'_v [Pa] of the soil, `spacing` of the axes and `diameter` [m].
double compute_pile_pressure(const StrengthTangent& soil, double effective_stress, double spacing, double diameter);

}  // namespace talus::lem
