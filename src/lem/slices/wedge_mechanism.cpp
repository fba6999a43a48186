// SPDX-License-Identifier: MIT
// Velocities of the wedges, power of the loads and dissipation, and the factor of the mechanism.
#include "lem/slices/wedge_mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lem/slices/slices.hpp"

namespace talus::lem {

namespace {

constexpr double degree = std::numbers::pi / 180;
/// Range and step of the inclinations of an interface [rad]. The factor is flat about its minimum, so that half a step
/// costs little accuracy.
constexpr double most_tilt = 67.5 * degree, tilt_step = 7.5 * degree;
constexpr int tilts = 19;
/// Bases shorter than this fraction of the length are merged: where a polyline enters another soil beside one of its
/// vertices, the jump of φ and the kink act as one.
constexpr double shortest = 0.05;
/// Points of an interface at which strength and weight are evaluated.
constexpr int places = 4;
constexpr double none = -std::numeric_limits<double>::infinity();

/// Returns the distance from `from` along the direction (dx, dy) to the ground; 0 if it does not meet it.
double measure_to_ground(const std::vector<Point>& ground, const Point& from, double dx, double dy) {
  double nearest = 0;
  for (std::size_t i = 1; i < ground.size(); ++i) {
    const double ex = ground[i][0] - ground[i - 1][0], ey = ground[i][1] - ground[i - 1][1];
    const double px = ground[i - 1][0] - from[0], py = ground[i - 1][1] - from[1], cross = dx * ey - dy * ex;
    if (cross == 0) continue;
    const double t = (px * ey - py * ex) / cross, s = (px * dy - py * dx) / cross;
    if (t > 0 && s >= 0 && s <= 1 && (nearest == 0 || t < nearest)) nearest = t;
  }
  return nearest;
}

}  // namespace

auto WedgeMechanism::Base::move(double q) const -> Motion {
  const double t = tan_friction * (reduced ? q : 1), cosine_of = 1 / std::sqrt(1 + t * t), sine_of = t * cosine_of;
  return {sine * cosine_of - cosine * sine_of, cosine * cosine_of + sine * sine_of, cosine_of, sine_of};
}

double WedgeMechanism::Interface::compute_power(double q, const Base::Motion& above, const Base::Motion& below,
                                                double power_below) const {
  const double t = tan_friction * q + kept_friction, cosine_of = 1 / std::sqrt(1 + t * t), away = t * cosine_of;
  const double turn = above.fall * below.run - above.run * below.fall;
  // Jump of velocity, that of the upper wedge less that of the lower one (T18.10): along the interface, downwards where
  // the base flattens, and away from it by dilation.
  const double along = turn >= 0 ? -cosine_of : cosine_of;
  const double rx = along * sine - away * cosine, ry = along * cosine + away * sine;
  const double on_below = -rx * below.fall - ry * below.run, on_above = -rx * above.fall - ry * above.run;
  if (!(std::abs(on_below) > 1e-6)) return none;
  const double jump = turn / on_below, ratio = on_above / on_below;
  if (!(ratio > 0) || jump < 0) return none;
  return ratio * power_below + down * (ratio * below.fall - above.fall) + push * (ratio * below.run - above.run) -
         ((q * cohesion + kept_cohesion) * cosine_of - uplift * away) * jump;
}

void WedgeMechanism::add_bar(const Slope& slope, const CutSurface& cut, const BarPart& part, const Slice& slice,
                             Base& base) const {
  const BarPull& pull = cut.pulls[static_cast<std::size_t>(part.pull)];
  if (pull.force() == 0 || &cut.slices[static_cast<std::size_t>(part.slice)] != &slice) return;
  const double force = part.fraction * pull.force();
  const double down = -force * part.direction[1], push = way_ * force * part.direction[0];
  const bool is_active = slope.section().bars[static_cast<std::size_t>(pull.bar)].is_active;
  (is_active ? base.down : base.held.down) += down;
  (is_active ? base.push : base.held.push) += push;
}

void WedgeMechanism::add_bases(const Slope& slope, const CutSurface& cut, double horizontal) {
  const double vertical = 1 + slope.section().vertical_acceleration;
  const auto size = cut.slices.size();
  bases_.clear();
  const Slice* last = nullptr;
  for (std::size_t i = 0; i < size; ++i) {
    const Slice& slice = cut.slices[cut.slides_left ? size - 1 - i : i];
    // A rigid wedge has one direction of velocity on its base, so a base ends where φ changes as well.
    const double steepness = 1 + slice.slope * slice.slope;
    const bool reduced = slope.section().soils[static_cast<std::size_t>(slice.soil)].reduced;
    const bool same = last != nullptr && std::abs(slice.slope - last->slope) < 1e-4 * steepness &&
                      std::abs(slice.tan_friction - last->tan_friction) < 1e-9 && reduced == bases_.back().reduced;
    if (!same) {
      bases_.emplace_back();
      bases_.back().cosine = 1 / std::sqrt(steepness);
      bases_.back().sine = slice.slope * bases_.back().cosine;
      bases_.back().tan_friction = slice.tan_friction;
      bases_.back().reduced = reduced;
    }
    Base& base = bases_.back();
    base.down += vertical * slice.weight + slice.surface_load;
    base.push += horizontal * slice.weight - slice.surface_thrust;
    for (const BarPart& part : cut.parts) add_bar(slope, cut, part, slice, base);
    base.length += slice.length;
    base.cohesion += slice.cohesion * slice.length;
    base.uplift += std::max(0.0, slice.pore_pressure) * slice.length;
    const Point& end = cut.slides_left ? slice.base_left : slice.base_right;
    base.end_x = end[0];
    base.end_y = end[1];
    last = &slice;
  }
  bases_.front().push += cut.crack_thrust;
  join_short_bases();
}

void WedgeMechanism::join_short_bases() {
  double all = 0;
  for (const Base& base : bases_) all += base.length;
  while (bases_.size() > 1) {
    auto least = bases_.end();
    for (auto base = bases_.begin(); base != bases_.end(); ++base) {
      const bool has_change = (base != bases_.begin() && (base - 1)->tan_friction != base->tan_friction) ||
                              (base + 1 != bases_.end() && (base + 1)->tan_friction != base->tan_friction);
      if (has_change && base->length < shortest * all && (least == bases_.end() || base->length < least->length))
        least = base;
    }
    if (least == bases_.end()) return;
    const bool first = least == bases_.begin(), last = least + 1 == bases_.end();
    const bool upwards = !first && (last || (least - 1)->length > (least + 1)->length);
    Base& other = upwards ? *(least - 1) : *(least + 1);
    other.length += least->length;
    other.down += least->down;
    other.push += least->push;
    other.held.down += least->held.down;
    other.held.push += least->held.push;
    other.cohesion += least->cohesion;
    other.uplift += least->uplift;
    if (upwards) other.end_x = least->end_x, other.end_y = least->end_y;
    bases_.erase(least);
  }
}

namespace {

/// Sets the strength of a law on an interface under the vertical stress `above` [Pa]. Any tangent to a curved envelope
/// gives an upper bound; the one at half the vertical stress is near the least. On steep planes clay has its strength
/// in direct shear, as on level ones.
void set_interface_strength(const Section& section, double above, double ground, double direction, Slice& here) {
  const Soil& soil = section.soils[static_cast<std::size_t>(here.soil)];
  const double vertical = std::max(0.0, above - std::max(0.0, here.water_pressure));
  const double inclination = std::remainder(direction, std::numbers::pi);
  const StrengthTangent tangent =
      soil.law->find_tangent({here.base_left, ground - here.base_left[1], vertical, inclination, 0, 0.5 * vertical});
  here.cohesion += tangent.cohesion;
  here.tan_friction = tangent.tan_friction;
}

}  // namespace

bool WedgeMechanism::measure_interface(const Slope& slope, const Base& base, double horizontal,
                                       Interface& interface) const {
  const Slope::Strips& strips = slope.strips();
  const Section& section = strips.section;
  const Point from{base.end_x, base.end_y};
  const double dx = way_ * interface.sine, dy = interface.cosine;
  const double length = measure_to_ground(section.ground, from, dx, dy);
  if (!(length > 0)) return false;
  interface.top = way_ * (from[0] + length * dx);
  if (interface.top < upper_ || interface.top > lower_) return false;
  const double width = std::abs(length * dx) / places, sign = interface.sine > 0 ? -1 : 1;
  const double vertical = 1 + section.vertical_acceleration;
  for (int k = 0; k < places; ++k) {
    const double t = length * (k + 0.5) / places;
    const Point p{from[0] + t * dx, from[1] + t * dy};
    const Strip& strip = strips.strip(strips.find(p[0]));
    const double x = p[0] - strip.left, ground = strip.ground.at(x);
    Slice here;
    here.left = here.right = p[0];
    here.base_left = here.base_right = p;
    const double weight = std::max(0.0, slope.weight_above(p[0], p[1], here.soil));
    add_strength(strips, strip, weight, nullptr, here);
    double pond = 0;
    if (strip.ponded) pond = section.water_unit_weight * std::max(0.0, strip.water.at(x) - ground);
    double load = pond, thrust = pond * strip.ground.slope;
    if (strips.loads) load += strip.load.at(x), thrust += strip.thrust.at(x);
    if (section.soils[static_cast<std::size_t>(here.soil)].law)
      set_interface_strength(section, weight + load, ground, std::atan2(dy, dx), here);
    const bool reduced = section.soils[static_cast<std::size_t>(here.soil)].reduced;
    (reduced ? interface.cohesion : interface.kept_cohesion) += here.cohesion * length / places;
    interface.uplift += std::max(0.0, here.pore_pressure) * length / places;
    (reduced ? interface.tan_friction : interface.kept_friction) += here.tan_friction / places;
    interface.down += sign * width * (vertical * weight + load);
    interface.push += sign * width * (horizontal * weight + way_ * thrust);
  }
  return true;
}

void WedgeMechanism::set(const Slope& slope, const CutSurface& cut, double horizontal) {
  way_ = cut.slides_left ? -1 : 1;
  const double left = cut.slices.front().left, right = cut.slices.back().right;
  upper_ = cut.slides_left ? -right : left;
  lower_ = cut.slides_left ? -left : right;
  add_bases(slope, cut, horizontal);
  interfaces_.clear();
  first_.assign(1, 0);
  for (std::size_t i = 0; i + 1 < bases_.size(); ++i) {
    double tilt = -most_tilt;
    for (int k = 0; k < tilts; ++k, tilt += tilt_step) {
      Interface interface;
      interface.sine = std::sin(tilt);
      interface.cosine = std::cos(tilt);
      if (measure_interface(slope, bases_[i], horizontal, interface)) interfaces_.push_back(interface);
    }
    first_.push_back(interfaces_.size());
  }
}

double WedgeMechanism::compute_net_power(double factor) const {
  const double q = 1 / factor;
  // From the lower end up: the power of everything below an interface, per unit velocity of the wedge above it. The
  // power is linear in that velocity, so that the best interfaces further down do not depend on it (T18.11).
  static thread_local std::vector<double> own;
  own.assign(interfaces_.size(), none);
  const double rounding = 1e-9 * (lower_ - upper_);
  Base::Motion below;
  double power_below = 0;
  for (std::size_t i = bases_.size(); i-- > 0;) {
    const Base& base = bases_[i];
    const Base::Motion motion = base.move(q);
    const double power = (base.down + q * base.held.down) * motion.fall +
                         (base.push + q * base.held.push) * motion.run -
                         (base.reduced ? q : 1) * base.cohesion * motion.cosine + base.uplift * motion.sine;
    for (std::size_t j = i + 1 < bases_.size() ? first_[i] : first_.back();
         j < first_[std::min(i + 1, first_.size() - 1)]; ++j) {
      const Interface& face = interfaces_[j];
      double more = none;
      if (i + 2 == bases_.size()) {
        more = 0;
      } else {
        for (std::size_t k = first_[i + 1]; k < first_[i + 2]; ++k)
          if (interfaces_[k].top >= face.top - rounding) more = std::max(more, own[k]);
      }
      if (more != none) own[j] = face.compute_power(q, motion, below, power_below + more);
    }
    below = motion;
    power_below = power;
  }
  if (bases_.size() == 1) return power_below;
  return power_below + *std::max_element(own.begin() + static_cast<std::ptrdiff_t>(first_[0]),
                                         own.begin() + static_cast<std::ptrdiff_t>(first_[1]));
}

double WedgeMechanism::search_factor(double start) const {
  constexpr double largest = 1000, smallest = 1e-3, tolerance = 1e-4;
  double low = std::clamp(start, 0.01, 100.0), high = low, at_low = compute_net_power(low), at_high = at_low;
  while (at_high < 0) {
    low = high, at_low = at_high;
    high *= 1.1;
    if (high > largest) return std::numeric_limits<double>::infinity();
    at_high = compute_net_power(high);
  }
  while (at_low >= 0) {
    high = low, at_high = at_low;
    low *= 0.9;
    if (low < smallest) return 0;
    at_low = compute_net_power(low);
  }
  // Regula falsi with halving (Illinois); bisection where the lower end has no compatible velocities.
  for (int k = 0; k < 50 && high - low > tolerance * high; ++k) {
    const bool smooth = std::isfinite(at_low);
    const double middle = smooth ? high - at_high * (high - low) / (at_high - at_low) : 0.5 * (low + high);
    const double value = compute_net_power(middle);
    if (smooth && std::abs(middle - (value >= 0 ? high : low)) <= 0.1 * tolerance * high) return middle;
    if (value >= 0) {
      high = middle, at_high = value;
      if (smooth) at_low *= 0.5;
    } else {
      low = middle, at_low = value;
      if (smooth) at_high *= 0.5;
    }
  }
  return high;
}

}  // namespace talus::lem
