// SPDX-License-Identifier: MIT
#pragma once
// What an element test does to its point, step by step.

#include <vector>

#include "input/case/point_test.hpp"
#include "laboratory/point_control.hpp"

namespace talus::laboratory {

/// Stresses of a specimen as the apparatus knows them, compression positive [Pa].
struct Cell {
  double axial = 0, radial = 0;
};

Cell find_start(const input::PointTest& test);

/// The step that moves what the test follows from `from` to `to`. `sucked` is χs at its end [Pa].
PointStep make_step(const input::PointTest& test, const Cell& start, double from, double to, double sucked);

/// What the test follows, at its start and at each of its goals.
std::vector<double> list_turns(const input::PointTest& test);

/// The same at every step. `reached` receives the steps of the goals.
std::vector<double> list_values(const input::PointTest& test, std::vector<std::size_t>& reached);

}  // namespace talus::laboratory
