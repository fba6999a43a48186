// SPDX-License-Identifier: MIT
#pragma once
// Sections of limit analysis for tests: columns of crossed triangles under the ground surface.

#include <functional>

#include "bounds/problem.hpp"

namespace talus::bounds {

/// Four triangles in each cell between the given x and `rows` layers from `base` to the ground. The base is fixed, the
/// ends are smooth.
Problem make_columns(const std::vector<double>& x, int rows, double base, const std::function<double(double)>& ground);

/// The triangles whose centre is kept, with their sides.
Problem keep_part(const Problem& whole, const std::function<bool(const Vec<2>&)>& is_kept);

/// One soil, and the body force with the weight downwards [N/m³].
void fill(Problem& problem, double cohesion, double friction_degrees, double unit_weight);

/// x from `from` over the ends of pieces, each cut into so many parts.
std::vector<double> divide(double from, const std::vector<std::pair<double, int>>& pieces);

/// Pressure on the sides whose middle lies between two x at a level [Pa].
void press(Problem& problem, double from, double to, double level, double pressure);

}  // namespace talus::bounds
