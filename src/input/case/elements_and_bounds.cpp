// SPDX-License-Identifier: MIT
// [bounds]: default size of the first mesh.
#include "input/case/elements_and_bounds.hpp"

#include <algorithm>
#include <limits>

#include "input/case/case.hpp"

namespace talus::input {

namespace {

/// Fractions of the section's height.
constexpr double first_size = 1.0 / 6, first_size_with_water = 1.0 / 12;

}  // namespace

double find_bounds_size(const Case& data) {
  if (data.bounds.size) return *data.bounds.size;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const mesh::Polygon& polygon : data.mesh.polygons)
    for (const auto& x : polygon.points) low = std::min(low, x[1]), high = std::max(high, x[1]);
  const bool has_water = data.initial.water.pressure != InitialPressure::zero;
  return (has_water ? first_size_with_water : first_size) * (high - low);
}

}  // namespace talus::input
