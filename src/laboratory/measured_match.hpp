// SPDX-License-Identifier: MIT
#pragma once
// Where measured points lie on the calculated curve of an element test.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "laboratory/point_test.hpp"

namespace talus::laboratory {

/// Which leg of the test each point belongs to: legs of loading and unloading cross the same abscissa. Points are in
/// the order of the measurement, so that only the places of the turns are open; they are those with the least way in
/// the wrong direction. All zero where the test has one leg.
std::vector<std::size_t> find_legs(const input::PointTest& test, const std::vector<std::array<double, 2>>& points);

/// The ordinate of the curve at an abscissa.
struct Reading {
  double y = 0;
  double missing = 0;  ///< the abscissa lies so far beyond what the leg reaches, and `y` is that of its nearest end
};

/// The first place on `leg` with the abscissa x.
Reading read_curve(const PointCurve& curve, std::size_t leg, const std::string& x_name, const std::string& y_name,
                   double x);

}  // namespace talus::laboratory
