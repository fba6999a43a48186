// SPDX-License-Identifier: MIT
// A slip surface: names of refusals, and where a circle meets the ground.

#include "lem/surface/surface.hpp"

#include <algorithm>
#include <cmath>

#include "lem/slices/strips.hpp"

namespace talus::lem {

const char* name_refusal(Refusal refusal) {
  switch (refusal) {
    case Refusal::none:
      return "none";
    case Refusal::outside:
      return "does not enter and leave the ground inside the model";
    case Refusal::too_shallow:
      return "too shallow";
    case Refusal::below_base:
      return "reaches below the base";
    case Refusal::no_driving:
      return "no driving force";
    case Refusal::m_alpha:
      return "m_alpha too small";
    case Refusal::tension:
      return "tension over too long a part of the base";
    case Refusal::thrust:
      return "line of thrust outside the sliding mass";
    case Refusal::not_converged:
      return "no convergence";
    case Refusal::lambda:
      return "λ outside its limits";
    case Refusal::steep_toe:
      return "passive end too steep";
    case Refusal::kinks:
      return "below the wedge mechanism of its own base";
    case Refusal::moment_axis:
      return "Bishop's method needs a circle";
    case Refusal::chart:
      return "depth over length outside the chart of Janbu's correction";
    case Refusal::count:
      break;
  }
  return "";
}

std::vector<std::array<double, 2>> find_arcs(const Slope& slope, const Circle& circle) {
  const double xc = circle.centre[0], yc = circle.centre[1];  // clang 14 captures no structured bindings
  const double left = std::max(slope.left(), xc - circle.radius), right = std::min(slope.right(), xc + circle.radius);
  std::vector<std::array<double, 2>> arcs;
  if (!(left < right)) return arcs;
  const auto arc = [&](double x) {
    return yc - std::sqrt(std::max(0.0, (circle.radius + x - xc) * (circle.radius - x + xc)));
  };
  double from = 0;
  // Below the ground since `from`; or since the side of the model or the end of the lower arc, which is no end on the
  // ground.
  bool inside = false, open = false;
  const auto& strips = slope.strips();
  for (int i = strips.find(left); i < static_cast<int>(strips.strips.size()) && strips.strip(i).left < right; ++i) {
    const Strip& strip = strips.strip(i);
    const double a = std::max(left, strip.left), b = std::min(right, strip.right);
    const bool below_a = arc(a) < strip.ground.at(a - strip.left), below_b = arc(b) < strip.ground.at(b - strip.left);
    if (below_a && !inside && !open) {
      inside = a > left;  // a vertical step of the ground begins the arc
      open = !inside;
      from = a;
    }
    if (!below_a) {
      if (inside) arcs.push_back({from, a});
      inside = open = false;
    }
    // Meets the straight ground y = g + s (x - xc) where (1 + s²) d² - 2 s h d + h² - R² = 0, h = yc - g, d = x - xc.
    const double s = strip.ground.slope, h = yc - strip.ground.at(xc - strip.left), q = 1 + s * s;
    const double root = circle.radius * circle.radius * q - h * h;
    if (root <= 0 || (below_a && below_b)) continue;
    const double enters = xc + (s * h - std::sqrt(root)) / q, leaves = xc + (s * h + std::sqrt(root)) / q;
    if (!below_a && enters >= a && enters < b) {
      inside = true;
      from = enters;
    }
    if (!below_b && leaves > a && leaves <= b) {
      if (inside && leaves > from) arcs.push_back({from, leaves});
      inside = open = false;
    }
  }
  return arcs;
}

}  // namespace talus::lem
