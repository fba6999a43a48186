// SPDX-License-Identifier: MIT
// Names of the reasons of rejection, intersections of a circle with the ground, faults of given surfaces, and lower
// convex hulls.
#include "lem/surface/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "lem/section/strips.hpp"
#include "lem/surface/base_line.hpp"

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
    case Refusal::held:
      return "soil that is not reduced holds the mass at any factor";
    case Refusal::too_small:
      return "sliding mass too small";
    case Refusal::excluded:
      return "enters an excluded area";
    case Refusal::passage:
      return "misses a window";
    case Refusal::direction:
      return "slides to the other side";
    case Refusal::blocked:
      return "meets a step of the base that it cannot pass";
    case Refusal::count:
      break;
  }
  return "";
}

std::vector<std::array<double, 2>> find_arcs(const Slope& slope, const Circle& circle) {
  const double xc = circle.centre[0], yc = circle.centre[1];  // clang 14 cannot capture structured bindings
  const double left = std::max(slope.left(), xc - circle.radius), right = std::min(slope.right(), xc + circle.radius);
  std::vector<std::array<double, 2>> arcs;
  if (!(left < right)) return arcs;
  const auto arc = [&](double x) {
    return yc - std::sqrt(std::max(0.0, (circle.radius + x - xc) * (circle.radius - x + xc)));
  };
  double from = 0;
  // `inside`: below the ground since `from`. `open`: below it since the side of the model or the end of the lower arc,
  // which is no end on the ground.
  bool inside = false, open = false;
  const auto& strips = slope.strips();
  for (int i = strips.find(left); i < static_cast<int>(strips.strips.size()) && strips.strip(i).left < right; ++i) {
    const Strip& strip = strips.strip(i);
    const double a = std::max(left, strip.left), b = std::min(right, strip.right);
    const bool below_a = arc(a) < strip.ground.at(a - strip.left), below_b = arc(b) < strip.ground.at(b - strip.left);
    if (below_a && !inside && !open) {
      inside = a > left;  // the arc starts at a vertical step of the ground
      open = !inside;
      from = a;
    }
    if (!below_a) {
      if (inside) arcs.push_back({from, a});
      inside = open = false;
    }
    // Intersects the straight ground y = g + s (x - xc) where (1 + s²) d² - 2 s h d + h² - R² = 0, h = yc - g, d = x -
    // xc.
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

// Faults of a slip surface given by the user.

namespace {

std::string name_surface(const Surface& surface) {
  const char* kind = surface.circle ? "slip circle" : "slip surface";
  return surface.name.empty() ? fmt::format("the {}", kind) : fmt::format("{} '{}'", kind, surface.name);
}

void check_end(const Slope& slope, const std::string& name, const BaseLine& base, bool left, double near,
               std::vector<std::string>& faults) {
  const BasePiece& piece = left ? base.pieces.front() : base.pieces.back();
  const double x = left ? piece.from : piece.to, y = base.at(piece, x);
  const ShownUnit& length = slope.section().units.length;
  const std::string end =
      fmt::format("{}: its {} end {}", name, left ? "left" : "right", format_point(Point{x, y}, length));
  if (x < slope.left() - near || x > slope.right() + near) {
    faults.push_back(fmt::format("{} lies outside the ground, which runs from x = {} to {}", end,
                                 format_coordinate(slope.left() / length.si),
                                 format_coordinate(slope.right() / length.si)));
  } else if (!base.ends_on_ground(slope.strips(), piece, x, near)) {
    const double off = y - slope.ground(x);
    faults.push_back(fmt::format("{} lies {} {} the ground, expected on it", end,
                                 format_value(std::abs(off), length, 4), off > 0 ? "above" : "below"));
  }
}

bool check_shape(const Surface& surface, const std::string& name, const ShownUnit& length,
                 std::vector<std::string>& faults) {
  if (surface.circle) {
    if (!(surface.circle->radius > 0)) faults.push_back(fmt::format("{}: its radius is not positive", name));
    if (!(surface.to > surface.from))
      faults.push_back(fmt::format("{} has no width: it meets the ground at no two points", name));
  } else {
    if (surface.line.size() < 2) faults.push_back(fmt::format("{} has fewer than two points", name));
    for (std::size_t i = 1; i < surface.line.size(); ++i) {
      const Point &a = surface.line[i - 1], &b = surface.line[i];
      if (!(b[0] > a[0]))
        faults.push_back(fmt::format("{} runs backwards from {} to {}: x must grow from point to point", name,
                                     format_point(a, length), format_point(b, length)));
    }
  }
  return faults.empty();
}

}  // namespace

std::vector<std::string> find_faults(const Slope& slope, const Surface& surface) {
  std::vector<std::string> faults;
  const std::string name = name_surface(surface);
  if (!check_shape(surface, name, slope.section().units.length, faults)) return faults;
  BaseLine base;
  if (base.lay(slope, surface, true) != Refusal::none) {
    faults.push_back(
        surface.circle
            ? fmt::format("{}: its ends lie beyond the lower half of the circle, or its centre below the base", name)
            : fmt::format("{} goes below the base at elevation {:.6g}", name, slope.section().base));
    return faults;
  }
  const double from = base.pieces.front().from, to = base.pieces.back().to, near = ground_tolerance * (to - from);
  check_end(slope, name, base, true, near, faults);
  check_end(slope, name, base, false, near, faults);
  if (!faults.empty()) return faults;
  const Refusal refusal = base.divide(slope, from, to);
  if (refusal == Refusal::below_base) faults.push_back(fmt::format("{} goes below the lowest region of soil", name));
  if (refusal == Refusal::outside) faults.push_back(fmt::format("{} rises above the ground between its ends", name));
  return faults;
}

// Lower convex hulls and the reduction of their vertices.

namespace {

/// Returns twice the signed area of the triangle, positive if b lies below the line from a to c.
double measure_turn(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

}  // namespace

Surface hang_polyline(const Slope& slope, double left, double right, const std::vector<Point>& points) {
  std::vector<Point> all{{left, slope.lower_ground(left)}, {right, slope.lower_ground(right)}};
  const double gap = 1e-9 * (right - left);
  auto add = [&](const Point& p) {
    if (p[0] > left + gap && p[0] < right - gap) all.push_back({p[0], std::max(p[1], slope.floor(p[0]))});
  };
  for (const Point& p : points) add(p);
  for (const Point& p : slope.section().ground) add(p);
  std::sort(all.begin(), all.end());
  Surface s;
  auto& line = s.line;
  for (const Point& p : all) {
    if (!line.empty() && p[0] - line.back()[0] < gap) continue;  // points of equal x: the lowest one came first
    while (line.size() > 1 && measure_turn(line[line.size() - 2], line.back(), p) <= 0) line.pop_back();
    line.push_back(p);
  }
  return s;
}

std::vector<Point> thin_points(std::vector<Point> line, int count) {
  while (static_cast<int>(line.size()) > std::max(count, 2)) {
    std::size_t least = 1;
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
      if (measure_turn(line[i - 1], line[i], line[i + 1]) < measure_turn(line[least - 1], line[least], line[least + 1]))
        least = i;
    line.erase(line.begin() + static_cast<std::ptrdiff_t>(least));
  }
  return line;
}

std::vector<Point> drop_straight_points(const std::vector<Point>& line) {
  constexpr double straight = 1e-6;  // sine of the turn, above the rounding of stored results
  if (line.size() < 3) return line;
  std::vector<Point> kept{line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Point &a = kept.back(), &b = line[i], &c = line[i + 1];
    const double before = std::hypot(b[0] - a[0], b[1] - a[1]), after = std::hypot(c[0] - b[0], c[1] - b[1]);
    if (std::abs(measure_turn(a, b, c)) > straight * before * after) kept.push_back(b);
  }
  kept.push_back(line.back());
  return kept;
}

}  // namespace talus::lem
