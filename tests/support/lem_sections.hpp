// SPDX-License-Identifier: MIT
#pragma once
// Sections of LEM for tests, and the factors of one surface by all methods.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lem/slices/solve.hpp"

namespace talus::lem {

inline constexpr double degree = std::numbers::pi / 180;

Soil make_soil(double cohesion, double friction_degrees, double unit_weight);

/// All below a line, down to far below the base and out to the ends of the ground.
Region make_region_below(const Section& section, int soil, std::vector<Point> line);

/// One soil everywhere. Units as the numbers are: kN and metres with γ_w = 9.81, or pounds and feet with 62.4.
Section make_section(std::vector<Point> ground, const Soil& soil, double base, double water = 9.81);

Surface make_arc(const Point& centre, double radius, double from, double to);

/// The widest arc of a whole circle.
Surface make_circle(const Slope& slope, const Point& centre, double radius);

Surface make_polyline(std::vector<Point> line);

/// Checks that report and do not reject: the equations are solved wherever they have a solution.
Checks report_only();

double find_factor(const Slope& slope, const Surface& surface, Method method, int slices = 100);

inline const std::vector<Method> all_methods{Method::fellenius,
                                             Method::bishop,
                                             Method::janbu,
                                             Method::janbu_corrected,
                                             Method::spencer,
                                             Method::morgenstern_price,
                                             Method::morgenstern_price_constant};

}  // namespace talus::lem
