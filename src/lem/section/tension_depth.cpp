// SPDX-License-Identifier: MIT
#include "lem/section/tension_depth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lem/slices/strips.hpp"

namespace talus::lem {
namespace {

/// Parts of the depth that are looked at before the limit is bisected.
constexpr int parts = 32;
constexpr int halvings = 40;
/// Places along the ground at which the depth is computed; linear between them.
constexpr int places_along = 200;

/// Stress that presses the sides of a crack together at depth z under the ground, less the water in it [Pa].
class Closure {
 public:
  Closure(const Slope& slope, double x, double water)
      : slope_(slope), strip_(slope.strips().strip(slope.strips().find(x))), x_(x), water_(water) {}

  double at(double z) const {
    const Section& section = slope_.section();
    const double dx = x_ - strip_.left, y = strip_.ground.at(dx) - z;
    const double inside = section.water_unit_weight * std::min(water_, z);
    int number = -1;
    const double soil_weight = slope_.weight_above(x_, y, number);
    if (number < 0) return -inside;
    const Soil& soil = section.soils[static_cast<std::size_t>(number)];
    const double standing = section.water_table.empty() ? 0 : std::max(0.0, strip_.water.at(dx) - strip_.ground.at(dx));
    const double vertical = soil_weight + strip_.load.at(dx) + section.water_unit_weight * standing;
    double cohesion = soil.cohesion, u = 0;
    if (soil.cohesion_gradient != 0) cohesion += soil.cohesion_gradient * std::max(0.0, soil.cohesion_level - y);
    if (!soil.undrained) u = find_pressure(soil, soil_weight, {x_, y}, cohesion);
    const double root = std::tan(std::numbers::pi / 4 - soil.friction_angle / 2);
    return root * root * (vertical - u) - 2 * cohesion * root + u - inside;
  }

 private:
  /// u as slices take it; suction adds to the cohesion.
  double find_pressure(const Soil& soil, double weight, const Point& p, double& cohesion) const {
    const double found = soil.pore_pressure_ratio > 0 ? soil.pore_pressure_ratio * weight : slope_.pore_pressure(p);
    if (found >= 0 || soil.suction == Suction::ignored) return std::max(0.0, found);
    const double suction = std::min(-found, soil.largest_suction);
    cohesion += soil.suction == Suction::phi_b
                    ? suction * std::tan(soil.phi_b)
                    : suction * (soil.saturation ? soil.saturation(suction) : 1) * std::tan(soil.friction_angle);
    return 0;
  }

  const Slope& slope_;
  const Strip& strip_;
  double x_, water_;
};

double compute_crack_depth(const Slope& slope, double x) {
  const TensionCrack& crack = *slope.section().crack;
  const Closure closure(slope, x, crack.water);
  double open = 0, closed = crack.depth;
  for (int i = 1; i <= parts; ++i) {
    const double z = crack.depth * i / parts;
    if (closure.at(z) > 0) {
      closed = z;
      break;
    }
    open = z;
  }
  for (int i = 0; i < halvings && open < crack.depth; ++i) {
    const double z = 0.5 * (open + closed);
    (closure.at(z) > 0 ? closed : open) = z;
  }
  return open;
}

}  // namespace

std::vector<Point> compute_crack_depths(const Slope& slope) {
  std::vector<Point> depths;
  const double step = (slope.right() - slope.left()) / places_along;
  for (const Strip& strip : slope.strips().strips) {
    const double width = strip.right - strip.left, hair = 1e-9 * width;
    const int count = 1 + static_cast<int>(width / step);
    for (int i = 0; i <= count; ++i) {
      const double x = strip.left + std::clamp(width * i / count, hair, width - hair);
      depths.push_back({x, compute_crack_depth(slope, x)});
    }
  }
  return depths;
}

}  // namespace talus::lem
