// SPDX-License-Identifier: MIT
// The simplified methods: Fellenius, Bishop, Janbu.

#include <algorithm>
#include <cmath>

#include "lem/surface/mass.hpp"

namespace talus::lem {

namespace {

struct Residual {
  double value = 0, slope = 0;
};

/// Driving less resisting moment (or horizontal force) with X = 0, and its derivative by q = 1/F.
Residual sum_simplified(const Mass& mass, bool moments, double q) {
  Residual sum{moments ? mass.moment : mass.crack, 0};
  for (const Wedge& wedge : mass.wedges) {
    const double t = wedge.friction * q, m_alpha = wedge.cosine + t * wedge.sine;
    const double normal = (wedge.down - q * wedge.strength * wedge.sine) / m_alpha;
    const double resistance = wedge.strength + wedge.friction * normal, shear = q * resistance;
    const double normal_slope = -wedge.sine * resistance / m_alpha;
    const double shear_slope = resistance + t * normal_slope;
    const double on_normal = moments ? wedge.arm_normal : wedge.sine;
    const double on_shear = moments ? wedge.arm_shear : wedge.cosine;
    sum.value += normal * on_normal - shear * on_shear + (moments ? 0 : wedge.push);
    sum.slope += normal_slope * on_normal - shear_slope * on_shear;
  }
  return sum;
}

}  // namespace

FelleniusSums sum_fellenius(const Mass& mass, bool moments) {
  FelleniusSums sums{0, moments ? mass.moment : mass.crack * mass.wedges.front().cosine};
  for (const Wedge& wedge : mass.wedges) {
    const double normal = wedge.down * wedge.cosine - wedge.push * wedge.sine;
    sums.driving += moments ? normal * wedge.arm_normal : wedge.down * wedge.sine + wedge.push * wedge.cosine;
    sums.resisting += (wedge.strength + normal * wedge.friction) * (moments ? wedge.arm_shear : 1);
  }
  return sums;
}

double solve_simplified(const Mass& mass, bool moments, double start, int& iterations) {
  // Nearly linear in 1/F, so that Newton's method needs a few steps from any start.
  double q = start > 0 ? 1 / start : 1;
  for (iterations = 1; iterations <= 60; ++iterations) {
    const Residual sum = sum_simplified(mass, moments, q);
    if (!(sum.slope < 0)) return 0;
    double next = q - sum.value / sum.slope;
    if (!(next > 0)) next = iterations < 30 ? 0.2 * q : 0;
    next = std::min(next, 5 * q);
    const double step = std::abs(next - q);
    q = next;
    if (!(q > 1e-9)) return 0;
    if (step <= 1e-13 * q) return 1 / q;
    if (step <= 1e-7 * q) return 1 / q;  // the error after this step is of the order of its square
  }
  return 0;
}

double correct_janbu(const CutSurface& cut, double& ratio) {
  const Point &a = cut.slices.front().base_left, &b = cut.slices.back().base_right;
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  double depth = 0;
  bool cohesion = false, friction = false;
  for (const Slice& slice : cut.slices) {
    const double dx = slice.base_right[0] - a[0], dy = slice.base_right[1] - a[1];
    depth = std::max(depth, (dy * (a[0] - b[0]) + dx * (b[1] - a[1])) / length);
    cohesion = cohesion || slice.cohesion > 0;
    friction = friction || slice.tan_friction > 0;
  }
  const double b1 = !friction ? 0.69 : !cohesion ? 0.31 : 0.50;
  ratio = depth / length;
  return 1 + b1 * (ratio - 1.4 * ratio * ratio);
}

}  // namespace talus::lem
