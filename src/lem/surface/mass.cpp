// SPDX-License-Identifier: MIT
// The sliding mass as the methods see it.

#include "lem/surface/mass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::lem {

void Mass::set(const Slope& slope, const CutSurface& cut, double horizontal) {
  const double vertical = 1 + slope.section().vertical_acceleration;
  const double way = cut.slides_left ? -1 : 1, xo = way * cut.moment_centre[0], yo = cut.moment_centre[1];
  const auto size = cut.slices.size();
  wedges.resize(size);
  radius = cut.radius;
  crack = cut.crack_thrust;
  moment = crack > 0 ? crack * (yo - cut.crack_thrust_level) : 0;
  scale = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const Slice& slice = cut.slices[cut.slides_left ? size - 1 - i : i];
    Wedge& wedge = wedges[i];
    const double fall = way * (slice.base_left[1] - slice.base_right[1]);
    wedge.sine = fall / slice.length;
    wedge.cosine = (slice.right - slice.left) / slice.length;
    wedge.friction = slice.tan_friction;
    wedge.uplift = std::max(0.0, slice.pore_pressure) * slice.length;
    wedge.strength = slice.cohesion * slice.length - wedge.uplift * slice.tan_friction;
    const double weight = vertical * slice.weight, earthquake = horizontal * slice.weight;
    wedge.down = weight + slice.surface_load;
    wedge.push = earthquake - slice.surface_thrust;
    const double x = way * 0.5 * (slice.left + slice.right), y = 0.5 * (slice.base_left[1] + slice.base_right[1]);
    wedge.arm_shear = (yo - y) * wedge.cosine - (x - xo) * wedge.sine;
    wedge.arm_normal = (x - xo) * wedge.cosine + (yo - y) * wedge.sine;
    moment += (xo - x) * weight + (xo - way * slice.load_x) * slice.surface_load + (yo - slice.centroid) * earthquake -
              (yo - slice.thrust_level) * slice.surface_thrust;
    scale += wedge.down;
  }
}

void Mass::set_interslice_function(bool half_sine, const CutSurface& cut) {
  const double left = cut.slices.front().left, span = cut.slices.back().right - left;
  const auto size = wedges.size();
  for (std::size_t i = 0; i < size; ++i) {
    const double x = cut.slides_left ? cut.slices[size - 1 - i].left : cut.slices[i].right;
    wedges[i].ratio = half_sine ? std::sin(std::numbers::pi * std::clamp((x - left) / span, 0.0, 1.0)) : 1;
  }
}

}  // namespace talus::lem
