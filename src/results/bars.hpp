// SPDX-License-Identifier: MIT
#pragma once
// Supports in MPM: where they lie at the end of a run, and what they carry.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "results/about.hpp"

namespace talus::results {

/// Limit of a support that is reached at the end.
enum class PointBarLimit { none, tension, pull_out, stripping, torn };
template <>
inline constexpr auto words<PointBarLimit> = std::array{"none", "tension", "pull_out", "stripping", "torn"};

/// A support at the end, per metre of slope; tension is positive.
struct PointBar {
  std::string support;              ///< name in the case
  std::string kind;                 ///< word of the case
  int row = 1;                      ///< from the top of the pattern
  std::vector<Point> line;          ///< the bar, from its head to its end [m]
  std::vector<double> place;        ///< distance from the head as installed, of the middle of each piece [m]
  std::vector<double> force;        ///< axial force there [N/m]
  std::vector<double> slip;         ///< of the points of the line in the soil, towards the end of the bar [m]
  double largest = 0;               ///< of `force` [N/m]
  double plate = 0;                 ///< force of plate, facing or connection [N/m]
  double tension = 0;               ///< largest force over tensile strength
  std::optional<double> pull_out;   ///< utilisation of the bond behind the largest force
  std::optional<double> stripping;  ///< utilisation of plate and bond in front of it
  int torn = 0;                     ///< pieces that have torn
  PointBarLimit limit = PointBarLimit::none;
};
void describe(Visitor& v, PointBar& r);

}  // namespace talus::results
