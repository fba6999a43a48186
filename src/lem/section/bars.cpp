// SPDX-License-Identifier: MIT
#include "lem/section/bars.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus::lem {

namespace {

/// Number of parts in which the resistance along a bar is summed, by its value in the middle of each.
constexpr int parts = 256;

}  // namespace

double BarDiagram::at(double s) const {
  if (sum.empty() || !(s > from)) return 0;
  const double place = (s - from) / step;
  const auto last = static_cast<double>(sum.size() - 1);
  if (place >= last) return sum.back();
  const auto i = static_cast<std::size_t>(place);
  return sum[i] + (place - static_cast<double>(i)) * (sum[i + 1] - sum[i]);
}

BarDiagram make_bar_diagram(const Slope& slope, const Bar& bar) {
  const double dx = bar.end[0] - bar.head[0], dy = bar.end[1] - bar.head[1], length = std::hypot(dx, dy);
  BarDiagram diagram;
  if (bar.hold == BarHold::end_anchor || bar.hold == BarHold::across) return diagram;
  diagram.from = std::min(bar.free_length, length);
  diagram.step = (length - diagram.from) / parts;
  diagram.sum.push_back(0);
  for (int i = 0; i < parts; ++i) {
    const double t = (diagram.from + (i + 0.5) * diagram.step) / length;
    const Point p{bar.head[0] + t * dx, bar.head[1] + t * dy};
    double resistance = 0;
    if (bar.hold == BarHold::bond) {
      resistance = bar.bond + (bar.bond_factor > 0 ? bar.bond_factor * slope.effective_stress(p) : 0);
    } else if (const int soil = slope.soil_at(p); soil >= 0) {
      StrengthPlane plane;
      plane.at = p;
      plane.depth = slope.ground(p[0]) - p[1];
      plane.vertical = plane.normal = slope.effective_stress(p);
      const Soil& here = slope.section().soils[static_cast<std::size_t>(soil)];
      resistance =
          compute_pile_pressure(find_strength(here, plane), plane.vertical, bar.spacing, bar.diameter) / bar.spacing;
    }
    diagram.sum.push_back(diagram.sum.back() + resistance * diagram.step);
  }
  return diagram;
}

double compute_pile_pressure(const StrengthTangent& soil, double effective_stress, double spacing, double diameter) {
  const double c = soil.cohesion, tangent = soil.tan_friction, d1 = spacing, d2 = spacing - diameter;
  constexpr double pi = std::numbers::pi;
  if (!(d2 > 0)) return 0;
  if (!(tangent > 1e-6))
    return std::max(0.0, c * (d1 * (3 * std::log(d1 / d2) + (d1 - d2) / d2 * std::tan(pi / 8)) - 2 * (d1 - d2)) +
                             effective_stress * (d1 - d2));
  const double angle = std::atan(tangent), n = std::pow(std::tan(pi / 4 + angle / 2), 2), root = std::sqrt(n);
  const double power = root * tangent + n - 1, a = 2 * tangent + 2 * root + 1 / root;
  const double wide = d1 * std::pow(d1 / d2, power);
  const double grown = std::exp((d1 - d2) / d2 * n * tangent * std::tan(pi / 8 + angle / 4));
  const double by_cohesion =
      wide * ((grown - 2 * root * tangent - 1) / (n * tangent) + a / power) - (d1 * a / power - 2 * d2 / root);
  return std::max(0.0, c * by_cohesion + effective_stress / n * (wide * grown - d2));
}

}  // namespace talus::lem
