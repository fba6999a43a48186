// SPDX-License-Identifier: MIT
// Ponded water beside vertical steps of the ground.

#include <algorithm>
#include <cmath>

#include "lem/slices/slices.hpp"

namespace talus::lem {

namespace {

/// Water beside a vertical step of the ground between `low` and `high` presses on the slice at the higher side.
void press_on_face(const Slope::Strips& strips, double water, double low, double high, double sign, Slice& slice) {
  const double top = std::min(water, high);
  if (!(top > low)) return;
  const double at_top = water - top, at_low = water - low, height = top - low;
  const double thrust = strips.section.water_unit_weight * 0.5 * (at_top + at_low) * height;
  const double level = top - height * (at_top + 2 * at_low) / (3 * (at_top + at_low));
  const double sum = slice.surface_thrust + sign * thrust;
  if (sum != 0) slice.thrust_level = (slice.surface_thrust * slice.thrust_level + sign * thrust * level) / sum;
  slice.surface_thrust = sum;
}

}  // namespace

void press_on_faces(const Slope::Strips& strips, std::vector<Slice>& slices, CrackEnd crack) {
  const double rise = 1e-6 * (slices.back().right - slices.front().left);
  for (std::size_t i = 0; i <= slices.size(); ++i) {
    const bool first = i == 0, last = i == slices.size();
    const double low = first ? slices.front().base_left[1] : slices[i - 1].top_right;
    const double high = last ? slices.back().base_right[1] : slices[i].top_left;
    if (std::abs(high - low) <= rise || (first && crack == CrackEnd::left) || (last && crack == CrackEnd::right))
      continue;
    const double x = first ? slices.front().left : slices[i - 1].right;
    const int strip = strips.find(x);
    const double water = strips.strip(strip).water.at(x - strips.strip(strip).left);
    if (high > low && !last) press_on_face(strips, water, low, high, 1, slices[i]);
    if (high < low && !first) press_on_face(strips, water, high, low, -1, slices[i - 1]);
  }
}

}  // namespace talus::lem
