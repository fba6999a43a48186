// SPDX-License-Identifier: MIT
#pragma once
// Resistance of bars along their length: bond from overburden and pore pressure, and the pressure of soil that flows
// between piles.

#include <functional>
#include <vector>

#include "lem/section/section.hpp"
#include "lem/section/slope.hpp"

namespace talus::lem {

/// Limit that governs the force of a bar. Those of a pile are its mechanisms: the mass flows past it (`lateral`, or the
/// given resistance governs), it moves with the mass through the stable soil (`embedment`), rotates in both soils, or
/// has a plastic hinge on one side of the surface or on both.
enum class BarLimit {
  tension,
  pull_out,
  stripping,
  prestress,
  lateral,
  shear,
  embedment,
  rotation,
  one_hinge,
  two_hinges
};

/// Resistance of a bar that is summed from its head: pull-out by bond, or the pressure of flowing soil [N/m].
struct BarDiagram {
  double from = 0, step = 1;     ///< first station, distance of the stations [m]
  std::vector<double> sum;       ///< at the stations; zero before the first
  std::vector<double> moment{};  ///< of that sum about the head [N m/m]; of piles only

  /// Returns the resistance of the part between two distances from the head [N/m].
  double find_part(double begin, double end) const { return at(end) - at(begin); }
  /// Returns its moment about the head [N m/m].
  double find_moment(double begin, double end) const { return moment_at(end) - moment_at(begin); }
  /// Returns the distance from the head up to which the resistance adds up to `total` [m].
  double find_place(double total) const;

 private:
  double at(double s) const;
  double moment_at(double s) const;
};

/// Resistance per metre of bar and of slope in soil of a strength at σ'_v.
using SoilPressure = std::function<double(const StrengthTangent& soil, double effective_stress)>;

/// Sums a pressure of the soil along a bar, with its moments.
BarDiagram make_bar_diagram(const Slope& slope, const Bar& bar, const SoilPressure& pressure);

/// Sums the resistance of a bar, with σ'_v of the slope along it.
BarDiagram make_bar_diagram(const Slope& slope, const Bar& bar);

/// Returns the lateral force per metre of its length of soil that flows plastically between piles, on one pile [N/m]
/// (Ito and Matsui 1975): c [Pa], φ [rad] and σ'_v [Pa] of the soil, `spacing` of the axes and `diameter` [m].
double compute_pile_pressure(const StrengthTangent& soil, double effective_stress, double spacing, double diameter);

}  // namespace talus::lem
