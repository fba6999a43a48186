// SPDX-License-Identifier: MIT
// Pore pressure and strength at the base of a slice.

#include "lem/slices/slice_strength.hpp"

#include <algorithm>
#include <cmath>

namespace talus::lem {

namespace {

double measure_distance(const Point& p, const Point& a, const Point& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

/// Linear between rows; the first value above the first row, none below the last.
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

/// Mean over the base of a slice, which may leave the roots' layer.
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

/// Bishop (1954): u = u₀ + B̄ Δσ_v, and Δσ_v is the weight of the standing water that is gone.
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
  if (strips.roots) {
    slice.root_cohesion = average_root_cohesion(strips, slice);
    slice.cohesion += slice.root_cohesion;
  }
  if (soil.undrained) return;
  double u = 0;
  if (before != nullptr && soil.b_bar && holds_water(section, soil)) {
    u = lower_pressure(strips, strip, *soil.b_bar, p[0], before->pore_pressure);
  } else if (soil.pore_pressure_ratio > 0) {
    u = soil.pore_pressure_ratio * weight;
  } else {
    const auto found = strips.pressure.empty() ? std::nullopt : strips.pressure.find(p);
    if (found) {
      u = *found;
    } else if (!section.water_table.empty()) {
      u = section.water_unit_weight * (strip.water.at(p[0] - strip.left) - p[1]);
    }
  }
  // The pressure that is used: suction only where the soil takes it.
  slice.pore_pressure = std::max(u, soil.suction == Suction::ignored ? 0.0 : -soil.largest_suction);
  if (slice.pore_pressure >= 0) return;
  const double suction = -slice.pore_pressure;
  slice.suction_strength = soil.suction == Suction::phi_b
                               ? suction * strips.tan_phi_b[number]
                               : suction * (soil.saturation ? soil.saturation(suction) : 1) * slice.tan_friction;
  slice.cohesion += slice.suction_strength;
}

}  // namespace talus::lem
