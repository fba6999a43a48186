// SPDX-License-Identifier: MIT
// Ponded water and loads on vertical steps of the ground.

#include <algorithm>
#include <cmath>

#include "lem/slices/slices.hpp"

namespace talus::lem {

namespace {

/// A vertical step of the ground at one side of a slice, which belongs to its higher side.
struct Step {
  double x = 0, low = 0, high = 0;
  double facing = 1;  ///< the soil is at larger x (1) or smaller x (-1)
  Slice* slice = nullptr;

  /// Adds a force at an elevation of the step.
  void load(double level, double right, double down) const {
    const double middle_x = 0.5 * (slice->left + slice->right);
    const double middle_y = 0.5 * (slice->base_left[1] + slice->base_right[1]);
    slice->surface_load += down;
    slice->surface_thrust += right;
    slice->surface_moment += (x - middle_x) * down + (level - middle_y) * right;
  }

  void press(double water, double unit_weight) const {
    const double top = std::min(water, high);
    if (!(top > low)) return;
    const double at_top = water - top, at_low = water - low, height = top - low;
    const double level = top - height * (at_top + 2 * at_low) / (3 * (at_top + at_low));
    load(level, facing * unit_weight * 0.5 * (at_top + at_low) * height, 0);
  }

  void press(const FaceLoad& face, double near) const {
    const double from = std::max(low, face.low), to = std::min(high, face.high);
    if (std::abs(face.x - x) > near || !(to > from)) return;
    load(0.5 * (from + to), face.traction[0] * (to - from), -face.traction[1] * (to - from));
  }
};

}  // namespace

void press_on_faces(const Slope::Strips& strips, std::vector<Slice>& slices, CrackEnd crack) {
  const double near = 1e-6 * (slices.back().right - slices.front().left);
  for (std::size_t i = 0; i <= slices.size(); ++i) {
    const bool first = i == 0, last = i == slices.size();
    const double low = first ? slices.front().base_left[1] : slices[i - 1].top_right;
    const double high = last ? slices.back().base_right[1] : slices[i].top_left;
    if (std::abs(high - low) <= near || (first && crack == CrackEnd::left) || (last && crack == CrackEnd::right))
      continue;
    const double x = first ? slices.front().left : slices[i - 1].right;
    Step step{x, low, high, 1, nullptr};
    if (high > low && !last) step.slice = &slices[i];
    if (high < low && !first) step = {x, high, low, -1, &slices[i - 1]};
    if (step.slice == nullptr) continue;
    const Strip& strip = strips.strip(strips.find(x));
    step.press(strip.water.at(x - strip.left), strips.section.water_unit_weight);
    for (const FaceLoad& face : strips.section.face_loads) step.press(face, near);
  }
}

}  // namespace talus::lem
