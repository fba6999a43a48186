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
    moment += (xo - x) * wedge.down + (yo - slice.centroid) * earthquake - (yo - y) * slice.surface_thrust -
              way * slice.surface_moment;
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

namespace {

/// Of the ground over a slice, positive where it falls in the direction of sliding.
double find_ground_slope(const CutSurface& cut, const Slice& slice) {
  const double way = cut.slides_left ? 1 : -1;
  return way * (slice.top_right - slice.top_left) / (slice.right - slice.left);
}

/// Of the line from the lower end to the upper one, on the ground.
double find_chord_slope(const CutSurface& cut) {
  const Slice &first = cut.slices.front(), &last = cut.slices.back();
  const double way = cut.slides_left ? 1 : -1;
  return way * (last.top_right - first.top_left) / (last.right - first.left);
}

/// Of the line from the lower end to where the ground of the mass is first as high as it gets.
double find_face_slope(const CutSurface& cut) {
  const auto size = cut.slices.size();
  const Slice& toe = cut.slides_left ? cut.slices.front() : cut.slices.back();
  const double x = cut.slides_left ? toe.left : toe.right, y = cut.slides_left ? toe.top_left : toe.top_right;
  double highest = y, at = x;
  for (std::size_t i = 0; i < size; ++i) {
    const Slice& slice = cut.slices[cut.slides_left ? i : size - 1 - i];
    const double level = cut.slides_left ? slice.top_right : slice.top_left;
    if (level <= highest + 1e-9 * std::abs(highest - y)) continue;
    highest = level;
    at = cut.slides_left ? slice.right : slice.left;
  }
  return at == x ? 0 : (highest - y) / std::abs(at - x);
}

}  // namespace

void Mass::set_inclinations(SliceMethod method, const CutSurface& cut) {
  const auto size = wedges.size();
  const double constant = method == SliceMethod::corps_1            ? find_chord_slope(cut)
                          : method == SliceMethod::modified_swedish ? find_face_slope(cut)
                                                                    : 0;
  for (std::size_t i = 0; i < size; ++i) {
    wedges[i].ratio = constant;
    if (method != SliceMethod::corps_2 && method != SliceMethod::lowe_karafiath) continue;
    // The side towards the lower end, between this slice and the next; the last side bears nothing.
    const auto number = [&](std::size_t k) { return cut.slides_left ? size - 1 - k : k; };
    const Slice &here = cut.slices[number(i)], &below = cut.slices[number(std::min(i + 1, size - 1))];
    const double ground = 0.5 * (std::atan(find_ground_slope(cut, here)) + std::atan(find_ground_slope(cut, below)));
    const double base = 0.5 * (here.alpha() + below.alpha());
    wedges[i].ratio = std::tan(method == SliceMethod::corps_2 ? ground : 0.5 * (ground + base));
  }
}

}  // namespace talus::lem
