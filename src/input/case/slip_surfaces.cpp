// SPDX-License-Identifier: MIT
// [[lem.surface]]: circles that cut the ground, and polylines that run from ground to ground through the soil.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "input/case/checks.hpp"
#include "input/case/soil_outline.hpp"

namespace talus::input {
namespace {

using Point = std::array<double, 2>;

/// How far an end of a polyline may be off the ground, as a share of its width.
constexpr double end_slack = 1e-2;
/// Places between the ends of a circle where it is looked at.
constexpr int places = 400;

void check_circle(const SlipSurface& s, const std::string& path, const SoilOutline& soil, Findings& findings) {
  const auto [xc, yc] = *s.centre;
  const double r = *s.radius, slack = soil.slack();
  if (check_range(s.ends, path + ".ends", "places x", findings)) {
    for (std::size_t i = 0; i < 2; ++i) {
      if (!soil.spans(s.ends[i]))
        return findings.add(path + ".ends", fmt::format("an end of surface '{}', x = {} m, is not on the ground, {}",
                                                        s.name, format_coordinate(s.ends[i]), soil.write_span()));
      if (std::abs(s.ends[i] - xc) > r + slack)
        return findings.add(path + ".ends", fmt::format("the end x = {} m of surface '{}' is farther from the centre "
                                                        "than its radius, {:.6g} m",
                                                        format_coordinate(s.ends[i]), s.name, r));
    }
    return;
  }
  if (!findings.is_sound(path)) return;
  const double from = std::max(xc - r, soil.left()), to = std::min(xc + r, soil.right());
  for (int i = 1; i < places; ++i) {
    const double x = from + (to - from) * i / places;
    const double low = yc - std::sqrt(std::max(0.0, r * r - (x - xc) * (x - xc)));
    if (from < to && low < soil.find_ground(x)) return;
  }
  findings.add(path,
               fmt::format("the circle of surface '{}' lies outside the ground: nothing of its lower arc is in the "
                           "soil",
                           s.name));
}

void check_end(const SlipSurface& s, const Point& end, const std::string& path, const SoilOutline& soil,
               Findings& findings) {
  if (!soil.spans(end[0]))
    return findings.add(path, fmt::format("surface '{}' begins or ends at x = {} m, outside the ground, {}", s.name,
                                          format_coordinate(end[0]), soil.write_span()));
  const double above = end[1] - soil.find_ground(end[0]);
  if (std::abs(above) > end_slack * (s.points.back()[0] - s.points.front()[0]))
    findings.add(path, fmt::format("the end {} of surface '{}' is {:.3g} m {} the ground; a surface "
                                   "goes from ground to ground",
                                   format_point(end), s.name, std::abs(above), above > 0 ? "above" : "below"));
}

void check_polyline(const SlipSurface& s, const std::string& path, const SoilOutline& soil, Findings& findings) {
  const std::string points = path + ".points";
  if (s.points.size() < 2)
    return findings.add(points,
                        fmt::format("surface '{}' has {} points; it needs at least 2", s.name, s.points.size()));
  for (std::size_t i = 1; i < s.points.size(); ++i)
    if (s.points[i][0] <= s.points[i - 1][0])
      return findings.add(
          fmt::format("{}.{}", points, i),
          fmt::format("surface '{}' goes from x = {} m to x = {} m; its points run from left to "
                      "right, x increasing",
                      s.name, format_coordinate(s.points[i - 1][0]), format_coordinate(s.points[i][0])));
  check_end(s, s.points.front(), points + ".0", soil, findings);
  check_end(s, s.points.back(), fmt::format("{}.{}", points, s.points.size() - 1), soil, findings);
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const Point& p = s.points[i];
    const std::string at = fmt::format("{}.{}", points, i);
    if (!findings.is_sound(at)) continue;
    if (p[1] < soil.bottom() - soil.slack())
      findings.add(at, fmt::format("the point {} of surface '{}' is below the soil, whose lowest level is "
                                   "{} m",
                                   format_point(p), s.name, format_coordinate(soil.bottom())));
    else if (i > 0 && i + 1 < s.points.size() && p[1] > soil.find_ground(p[0]) + soil.slack())
      findings.add(at, fmt::format("the point {} of surface '{}' is above the ground", format_point(p), s.name));
  }
}

}  // namespace

void check_slip_surface(const SlipSurface& s, const std::string& path, const SoilOutline& soil, Findings& findings) {
  const bool has_circle = s.centre || s.radius, has_line = findings.places.is_given(path + ".points");
  if (has_circle == has_line)
    return findings.add(path,
                        fmt::format("surface '{}' {}; give 'centre' and 'radius' of a circle, or the 'points' of a "
                                    "polyline",
                                    s.name, has_line ? "is a circle and a polyline" : "has no shape"));
  if (has_line) {
    if (findings.places.is_given(path + ".ends"))
      findings.add(path + ".ends", "'ends' belongs to a circle; a polyline ends at its first and last point");
    return check_polyline(s, path, soil, findings);
  }
  if (!s.centre || !s.radius)
    return findings.add(path,
                        fmt::format("the circle of surface '{}' has no '{}'", s.name, s.centre ? "radius" : "centre"));
  check_circle(s, path, soil, findings);
}

}  // namespace talus::input
