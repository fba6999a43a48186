// SPDX-License-Identifier: MIT
// Forces on the slices of a solution, and the line of thrust.

#include <algorithm>
#include <cmath>
#include <limits>

#include "lem/surface/mass.hpp"

namespace talus::lem {

void find_forces(const Mass& mass, double factor, double lambda, std::vector<Forces>& forces) {
  const double q = 1 / factor;
  double e = mass.crack, x = 0;
  forces.clear();
  for (const Wedge& w : mass.wedges) {
    const double t = w.friction * q, a = lambda * w.ratio, slip = w.sine - t * w.cosine;
    const double m = w.cosine + t * w.sine + a * slip;
    const double pushed = e - q * w.strength * w.cosine + w.push;
    Forces f;
    f.normal = (w.down + x - q * w.strength * w.sine - a * pushed) / m;
    f.shear = q * (w.strength + w.friction * f.normal);
    f.normal_side = e = pushed + f.normal * slip;
    f.shear_side = x = a * e;
    f.m_alpha = m / std::sqrt(1 + a * a);
    forces.push_back(f);
  }
}

double measure_residual(const Mass& mass, const std::vector<Forces>& forces, bool of_forces, bool of_moments) {
  double residual = of_forces ? std::abs(forces.back().normal_side) / mass.scale : 0;
  if (of_moments) {
    double moment = mass.moment;
    for (std::size_t i = 0; i < forces.size(); ++i)
      moment += forces[i].normal * mass.wedges[i].arm_normal - forces[i].shear * mass.wedges[i].arm_shear;
    residual = std::max(residual, std::abs(moment) / (mass.scale * mass.radius));
  }
  return residual;
}

void find_thrust_line(const CutSurface& cut, const Mass& mass, double horizontal, const std::vector<Forces>& forces,
                      std::vector<double>& level) {
  const double way = cut.slides_left ? -1 : 1;
  double largest = std::abs(mass.crack);
  for (const Forces& f : forces) largest = std::max(largest, std::abs(f.normal_side));
  double e = mass.crack, x = 0, moment = e * cut.crack_thrust_level;  // E times its elevation
  const auto size = cut.slices.size();
  level.assign(size, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < size; ++i) {
    const Slice& slice = cut.slices[cut.slides_left ? size - 1 - i : i];
    const Forces& f = forces[i];
    const double y = 0.5 * (slice.base_left[1] + slice.base_right[1]);
    const double half = 0.5 * (slice.right - slice.left);
    // About the middle of the base, where N and T have no moment.
    const double about = moment - y * e - half * (x + f.shear_side) + way * slice.surface_moment +
                         (slice.centroid - y) * horizontal * slice.weight;
    e = f.normal_side;
    x = f.shear_side;
    moment = about + y * e;
    if (std::abs(e) > 1e-3 * largest) level[i] = moment / e;
  }
}

}  // namespace talus::lem
