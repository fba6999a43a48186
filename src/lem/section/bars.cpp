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

double BarDiagram::moment_at(double s) const {
  if (moment.empty() || !(s > from)) return 0;
  const double place = (s - from) / step;
  if (place >= static_cast<double>(moment.size() - 1)) return moment.back();
  const auto i = static_cast<std::size_t>(place);
  const double station = from + static_cast<double>(i) * step;
  return moment[i] + (sum[i + 1] - sum[i]) / step * 0.5 * (s * s - station * station);
}

double BarDiagram::find_place(double total) const {
  const auto next = std::upper_bound(sum.begin(), sum.end(), total);
  if (next == sum.begin()) return from;
  const auto i = static_cast<std::size_t>(next - sum.begin()) - 1;
  const double part = next == sum.end() ? 0 : (total - sum[i]) / (sum[i + 1] - sum[i]);
  return from + (static_cast<double>(i) + part) * step;
}

BarDiagram make_bar_diagram(const Slope& slope, const Bar& bar) {
  if (bar.hold == BarHold::soil_pressure)
    return make_bar_diagram(slope, bar, [&bar](const StrengthTangent& soil, double effective_stress) {
      return compute_pile_pressure(soil, effective_stress, bar.spacing, bar.diameter) / bar.spacing;
    });
  const double dx = bar.end[0] - bar.head[0], dy = bar.end[1] - bar.head[1], length = std::hypot(dx, dy);
  BarDiagram diagram;
  if (bar.hold != BarHold::bond) return diagram;
  diagram.from = std::min(bar.free_length, length);
  diagram.step = (length - diagram.from) / parts;
  diagram.sum.push_back(0);
  for (int i = 0; i < parts; ++i) {
    const double t = (diagram.from + (i + 0.5) * diagram.step) / length;
    const Point p{bar.head[0] + t * dx, bar.head[1] + t * dy};
    const double resistance = bar.bond + (bar.bond_factor > 0 ? bar.bond_factor * slope.effective_stress(p) : 0);
    diagram.sum.push_back(diagram.sum.back() + resistance * diagram.step);
  }
  return diagram;
}

BarDiagram make_bar_diagram(const Slope& slope, const Bar& bar, const SoilPressure& pressure) {
  const double dx = bar.end[0] - bar.head[0], dy = bar.end[1] - bar.head[1], length = std::hypot(dx, dy);
  BarDiagram diagram{.from = 0, .step = length / parts, .sum = {0}, .moment = {0}};
  for (int i = 0; i < parts; ++i) {
    const double t = (i + 0.5) / parts;
    const Point p{bar.head[0] + t * dx, bar.head[1] + t * dy};
    const int soil = slope.soil_at(p);
    double force = 0;
    if (soil >= 0) {
      StrengthPlane plane;
      plane.at = p;
      plane.depth = slope.ground(p[0]) - p[1];
      plane.vertical = plane.normal = slope.effective_stress(p);
      const Soil& here = slope.section().soils[static_cast<std::size_t>(soil)];
      force = pressure(find_strength(here, plane), plane.vertical) * diagram.step;
    }
    diagram.sum.push_back(diagram.sum.back() + force);
    diagram.moment.push_back(diagram.moment.back() + force * t * length);
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
