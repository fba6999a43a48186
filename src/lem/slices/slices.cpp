// SPDX-License-Identifier: MIT
// Geometry, weight, loads, pore pressure and strength of the slices over a base.
#include "lem/slices/slices.hpp"

#include <algorithm>
#include <cmath>

namespace talus::lem {

namespace {

/// Returns geometry, weight and loads of one slice, with forces along +x as if the mass slid to the left. `before`: the
/// same slice before drawdown.
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
  double moment = part * 0.5 * (layer.top.at(dx) - y);  // relative to the base, since elevations may be large
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

/// Returns the slice over a base in another slope whose breaks are breaks of the own one as well. `near`: see below.
Slice make_slice_of(const Slope::Strips& strips, const Point& a, const Point& b, double near) {
  const double x = 0.5 * (a[0] + b[0]), y = 0.5 * (a[1] + b[1]);
  Stretch own;
  own.strip = strips.find(x);
  const Strip& strip = strips.strip(own.strip);
  // As in BaseLine::divide(): along a boundary of layers the upper layer counts.
  own.layer = strips.find_layer(strip, x - strip.left, y + near);
  return make_slice(strips, own, a, b);
}

/// Moves an end that lies on the ground within rounding exactly onto it.
Point snap_end(const Slope::Strips& strips, const BaseLine& base, const Stretch& stretch, double x, double near) {
  const Strip& strip = strips.strip(stretch.strip);
  const BasePiece& piece = base.pieces[static_cast<std::size_t>(stretch.piece)];
  const Point ground{x, strip.ground.at(x - strip.left)};
  return base.passes(piece, ground, near) ? ground : Point{x, base.at(piece, x)};
}

}  // namespace

Slice weigh_slice(const Slope& slope, const Slice& slice) {
  return make_slice_of(slope.strips(), slice.base_left, slice.base_right, 1e-6 * (slice.right - slice.left));
}

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
      if (strips.before) cut.before.push_back(make_slice_of(strips.before->strips(), a, b, 1e-6 * length));
      cut.slices.push_back(make_slice(strips, stretch, a, b, strips.before ? &cut.before.back() : nullptr));
      const Slice& slice = cut.slices.back();
      cut.area += 0.5 * (b[0] - a[0]) * (slice.top_left - a[1] + slice.top_right - b[1]);
      cut.depth = std::max({cut.depth, slice.top_left - a[1], slice.top_right - b[1]});
      a = b;
    }
  }
}

// Pore pressure and strength at the base of a slice.

namespace {

double measure_distance(const Point& p, const Point& a, const Point& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

/// Interpolates linearly between the rows; returns the first value above the first row and 0 below the last.
double read_profile(const std::vector<std::array<double, 2>>& profile, double depth) {
  if (profile.empty() || depth > profile.back()[0]) return 0;
  if (depth <= profile.front()[0]) return profile.front()[1];
  for (std::size_t i = 1; i < profile.size(); ++i)
    if (depth <= profile[i][0]) {
      const auto &a = profile[i - 1], &b = profile[i];
      return b[0] > a[0] ? a[1] + (b[1] - a[1]) * (depth - a[0]) / (b[0] - a[0]) : b[1];
    }
  return 0;
}

/// Returns the mean over the base of a slice, part of which may lie outside the root zone.
double average_root_cohesion(const Slope::Strips& strips, const Slice& slice) {
  constexpr int places = 4;
  double sum = 0;
  for (int k = 0; k < places; ++k) {
    const double t = (k + 0.5) / places;
    const Point p{slice.base_left[0] + t * (slice.base_right[0] - slice.base_left[0]),
                  slice.base_left[1] + t * (slice.base_right[1] - slice.base_left[1])};
    sum += find_root_cohesion(strips.section, p);
  }
  return sum / places;
}

/// Returns the suction of a slice as far as it is an effective stress [Pa]: not where it has an angle of its own.
double find_suction_stress(const Soil& soil, const Slice& slice) {
  if (!(slice.pore_pressure < 0) || soil.suction == Suction::phi_b) return 0;
  const double suction = -slice.pore_pressure;
  return suction * (soil.saturation ? soil.saturation(suction) : 1);
}

/// Returns the strength due to the suction of a slice whose pore pressure is negative [Pa].
double find_suction_strength(const Slope::Strips& strips, const Slice& slice) {
  const auto number = static_cast<std::size_t>(slice.soil);
  const Soil& soil = strips.section.soils[number];
  if (soil.suction == Suction::phi_b) return -slice.pore_pressure * strips.tan_phi_b[number];
  return find_suction_stress(soil, slice) * slice.tan_friction;
}

/// Returns u = u₀ + B̄ Δσ_v (Bishop 1954), where -Δσ_v is the weight of the ponded water that was removed.
double lower_pressure(const Slope::Strips& strips, const Strip& strip, double b_bar, double x, double before) {
  const double dx = x - strip.left, ground = strip.ground.at(dx);
  const double gone = std::max(0.0, strip.water_before.at(dx) - ground) - std::max(0.0, strip.water.at(dx) - ground);
  return before - b_bar * strips.section.water_unit_weight * gone;
}

}  // namespace

double find_root_cohesion(const Section& section, const Point& p) {
  double depth = -1, sum = 0;
  for (const RootCohesion& roots : section.roots) {
    if (p[0] < roots.from || p[0] > roots.to) continue;
    if (depth < 0) {
      depth = std::numeric_limits<double>::infinity();
      for (std::size_t i = 1; i < section.ground.size(); ++i)
        depth = std::min(depth, measure_distance(p, section.ground[i - 1], section.ground[i]));
    }
    sum += read_profile(roots.profile, depth);
  }
  return sum;
}

void add_strength(const Slope::Strips& strips, const Strip& strip, double weight, const Slice* before, Slice& slice) {
  const Section& section = strips.section;
  const auto number = static_cast<std::size_t>(slice.soil);
  const Soil& soil = section.soils[number];
  const Point p{0.5 * (slice.left + slice.right), 0.5 * (slice.base_left[1] + slice.base_right[1])};
  slice.tan_friction = strips.tan_friction[number];
  slice.cohesion = soil.cohesion;
  if (soil.cohesion_gradient != 0) slice.cohesion += soil.cohesion_gradient * std::max(0.0, soil.cohesion_level - p[1]);
  if (strips.roots && soil.takes_roots) {
    slice.root_cohesion = average_root_cohesion(strips, slice);
    slice.cohesion += slice.root_cohesion;
  }
  if (soil.undrained && !soil.law) return;
  double u = 0;
  if (before != nullptr && soil.b_bar && holds_water(section, soil)) {
    u = lower_pressure(strips, strip, *soil.b_bar, p[0], before->pore_pressure);
  } else if (const double ratio = section.find_pressure_ratio(soil, p); ratio > 0) {
    u = ratio * weight;
  } else {
    const auto found = strips.pressure.empty() ? std::nullopt : strips.pressure.find(p);
    if (found) {
      u = *found;
    } else if (!section.water_table.empty() || soil.piezometric_line >= 0) {
      u = section.water_unit_weight * (strip.find_water(soil).at(p[0] - strip.left) - p[1]);
    }
  }
  slice.water_pressure = u;
  if (soil.undrained) return;
  // The pressure that is used: suction only if the soil takes it into account.
  slice.pore_pressure = std::max(u, soil.suction == Suction::ignored ? 0.0 : -soil.largest_suction);
  if (slice.pore_pressure >= 0) return;
  slice.suction_strength = find_suction_strength(strips, slice);
  slice.cohesion += slice.suction_strength;
}

double set_law_strengths(const Slope::Strips& strips, std::vector<Slice>& slices, bool has_forces,
                         const std::vector<Slice>& before_drawdown) {
  double change = 0, sum = 0;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    Slice& slice = slices[i];
    const Soil& soil = strips.section.soils[static_cast<std::size_t>(slice.soil)];
    if (!soil.law) continue;
    if (strips.before && soil.undrained) {
      slice.cohesion = before_drawdown[i].cohesion, slice.tan_friction = before_drawdown[i].tan_friction;
      continue;
    }
    const double width = slice.right - slice.left, dip = slice.alpha(),
                 total = (slice.weight + slice.surface_load) / width, u = std::max(0.0, slice.water_pressure);
    StrengthPlane plane;
    plane.at = {0.5 * (slice.left + slice.right), 0.5 * (slice.base_left[1] + slice.base_right[1])};
    plane.depth = 0.5 * (slice.top_left + slice.top_right) - plane.at[1];
    const double middle = 0.5 * (slice.left + slice.right);
    const Strip& strip = strips.strip(strips.find(middle));
    plane.vertical = std::max(0.0, total - strip.variable_load.at(middle - strip.left) - u);
    plane.inclination = std::atan2(slice.base_right[1] - slice.base_left[1], width);
    plane.dip = dip;
    // Suction adds its strength to the cohesion, but only as an effective stress does it move along the envelope.
    const double net = has_forces ? slice.normal / slice.length - std::max(0.0, slice.pore_pressure)
                                  : std::max(0.0, total - u) * std::cos(dip) * std::cos(dip);
    plane.normal = net + find_suction_stress(soil, slice);
    const StrengthTangent tangent = soil.law->find_tangent(plane);
    const double before = slice.cohesion + net * slice.tan_friction;
    slice.tan_friction = tangent.tan_friction;
    slice.suction_strength = slice.pore_pressure < 0 ? find_suction_strength(strips, slice) : 0;
    slice.cohesion = tangent.cohesion + slice.root_cohesion + slice.suction_strength;
    const double after = slice.cohesion + net * slice.tan_friction;
    change = std::max(change, std::abs(after - before));
    sum += std::abs(after) / static_cast<double>(slices.size());
  }
  return sum > 0 ? change / sum : 0;
}

// Ponded water and loads on vertical steps of the ground.

namespace {

/// A vertical step of the ground at one side of a slice; the slice on its higher side carries the load.
struct Step {
  double x = 0, low = 0, high = 0;
  double facing = 1;  ///< the soil is at larger x (1) or smaller x (-1)
  Slice* slice = nullptr;

  /// Adds a force at an elevation of the step to the slice.
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
    for (const Slurry& slurry : strips.section.slurries)
      if (x > slurry.from - near && x < slurry.to + near) step.press(slurry.level, slurry.unit_weight);
  }
}

}  // namespace talus::lem
