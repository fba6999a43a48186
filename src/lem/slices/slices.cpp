// SPDX-License-Identifier: MIT
// Geometry, weight, loads and strength of the slices over a base.

#include <algorithm>
#include <cmath>

#include "lem/slices/slice_strength.hpp"
#include "lem/slices/slices.hpp"

namespace talus::lem {

namespace {

/// Geometry, weight and loads of one slice; forces along +x as if the mass slid to the left. `before`: the same before
/// drawdown.
Slice make_slice(const Slope::Strips& strips, const Stretch& stretch, const Point& a, const Point& b,
                 const Slice* before = nullptr) {
  const Section& section = strips.section;
  const Strip& strip = strips.strip(stretch.strip);
  const Layer& layer = strips.layer(stretch.layer);
  Slice slice;
  slice.left = a[0];
  slice.right = b[0];
  slice.base_left = a;
  slice.base_right = b;
  const double width = b[0] - a[0], x = 0.5 * (a[0] + b[0]), y = 0.5 * (a[1] + b[1]), dx = x - strip.left;
  slice.top_left = strip.ground.at(a[0] - strip.left);
  slice.top_right = strip.ground.at(b[0] - strip.left);
  slice.soil = layer.soil;
  slice.slope = (b[1] - a[1]) / width;
  slice.length = std::sqrt(width * width + (b[1] - a[1]) * (b[1] - a[1]));
  const double part = layer.unit_weight * std::max(0.0, layer.top.at(dx) - y), above = layer.weight.at(dx);
  double moment = part * 0.5 * (layer.top.at(dx) - y);  // about the base: elevations may be large
  for (int i = strip.first; i < stretch.layer; ++i) {
    const Layer& other = strips.layer(i);
    const double top = other.top.at(dx), bottom = other.bottom.at(dx);
    moment += other.unit_weight * 0.5 * (top - bottom) * (top - y + bottom - y);
  }
  const double weight = above + part;
  slice.weight = weight * width;
  slice.centroid = y + (weight > 0 ? moment / weight : 0);
  slice.earthquake = section.horizontal_acceleration * slice.weight;
  const auto load = [&](double at, double down, double right) {
    slice.surface_load += down;
    slice.surface_thrust += right;
    slice.surface_moment += (at - x) * down + (strip.ground.at(at - strip.left) - y) * right;
  };
  if (strips.loads) load(x, strip.load.at(dx) * width, strip.thrust.at(dx) * width);
  if (strip.ponded) {
    const double left = std::max(0.0, strip.water.at(a[0] - strip.left) - slice.top_left);
    const double right = std::max(0.0, strip.water.at(b[0] - strip.left) - slice.top_right);
    const double down = section.water_unit_weight * 0.5 * (left + right) * width;
    if (down > 0) {
      const double at = a[0] + width * (left + 2 * right) / (3 * (left + right));
      load(at, down, down * strip.ground.slope);
    }
  }
  add_strength(strips, strip, weight, before, slice);
  return slice;
}

/// The same slice of the slope before drawdown, whose breaks are all among those of the slope after it.
Slice make_slice_before(const Slope::Strips& strips, const Stretch& stretch, const Point& a, const Point& b) {
  const double x = 0.5 * (a[0] + b[0]), y = 0.5 * (a[1] + b[1]);
  Stretch own = stretch;
  own.strip = strips.find(x);
  const Strip& strip = strips.strip(own.strip);
  // As BaseLine::divide() does: along a boundary of layers the upper one counts.
  own.layer = strips.find_layer(strip, x - strip.left, y + 1e-6 * (stretch.to - stretch.from));
  return make_slice(strips, own, a, b);
}

/// Puts an end that lies on the ground up to rounding exactly there.
Point snap_end(const Slope::Strips& strips, const BaseLine& base, const Stretch& stretch, double x, double near) {
  const Strip& strip = strips.strip(stretch.strip);
  const BasePiece& piece = base.pieces[static_cast<std::size_t>(stretch.piece)];
  const Point ground{x, strip.ground.at(x - strip.left)};
  return base.passes(piece, ground, near) ? ground : Point{x, base.at(piece, x)};
}

}  // namespace

void fill_slices(const Slope::Strips& strips, const BaseLine& base, int count, CutSurface& cut) {
  const Stretch &front = base.stretches.front(), &back = base.stretches.back();
  const double span = back.to - front.from, near = ground_tolerance * span;
  const auto place = [&](const Stretch& stretch, double x) {
    return Point{x, base.at(base.pieces[static_cast<std::size_t>(stretch.piece)], x)};
  };
  const Point first = snap_end(strips, base, front, front.from, near);
  const Point last = snap_end(strips, base, back, back.to, near);
  cut.slices.clear();
  cut.before.clear();
  cut.area = cut.depth = 0;
  for (const Stretch& stretch : base.stretches) {
    const double length = stretch.to - stretch.from;
    const int parts = std::max(1, static_cast<int>(std::lround(count * length / span)));
    Point a = &stretch == &front ? first : place(stretch, stretch.from);
    for (int k = 1; k <= parts; ++k) {
      const double x = k == parts ? stretch.to : stretch.from + length * k / parts;
      const Point b = k == parts && &stretch == &back ? last : place(stretch, x);
      if (strips.before) cut.before.push_back(make_slice_before(strips.before->strips(), stretch, a, b));
      cut.slices.push_back(make_slice(strips, stretch, a, b, strips.before ? &cut.before.back() : nullptr));
      const Slice& slice = cut.slices.back();
      cut.area += 0.5 * (b[0] - a[0]) * (slice.top_left - a[1] + slice.top_right - b[1]);
      cut.depth = std::max({cut.depth, slice.top_left - a[1], slice.top_right - b[1]});
      a = b;
    }
  }
}

}  // namespace talus::lem
