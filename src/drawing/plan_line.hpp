// SPDX-License-Identifier: MIT
#pragma once
// Places in plan, and the line of a section through them.

#include <algorithm>
#include <cmath>
#include <vector>

namespace talus::drawing {

/// A place in plan; `northing` is NaN where a table has none.
struct PlanPlace {
  double x = 0, northing = std::nan("");
};

/// A line in plan on which places are projected.
class PlanLine {
 public:
  /// Fits the line through the places by least squares of their distances.
  explicit PlanLine(const std::vector<PlanPlace>& places) {
    for (const PlanPlace& p : places) middle_.x += p.x, middle_.northing += p.northing;
    middle_.x /= static_cast<double>(places.size());
    middle_.northing /= static_cast<double>(places.size());
    double xx = 0, xy = 0, yy = 0;
    for (const PlanPlace& p : places) {
      const double dx = p.x - middle_.x, dy = p.northing - middle_.northing;
      xx += dx * dx, xy += dx * dy, yy += dy * dy;
    }
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    along_ = {std::cos(angle), std::sin(angle)};
    if (along_.x < -1e-9) along_ = {-along_.x, -along_.northing};
    for (const PlanPlace& p : places) {
      start_ = std::min(start_, measure(p));
      widest_ = std::max(widest_, std::abs(measure_across(p)));
    }
  }

  double project(const PlanPlace& p) const { return measure(p) - start_; }

  /// Returns the distance of a place from the middle of the places, along the line [m].
  double measure(const PlanPlace& p) const {
    return (p.x - middle_.x) * along_.x + (p.northing - middle_.northing) * along_.northing;
  }
  /// Returns the distance of a place from the line [m].
  double measure_across(const PlanPlace& p) const {
    return (p.northing - middle_.northing) * along_.x - (p.x - middle_.x) * along_.northing;
  }
  double widest() const { return widest_; }  ///< [m]

  /// Returns the direction of the line, clockwise from north [°].
  double compute_azimuth() const {
    const double degrees = std::atan2(along_.x, along_.northing) * 180 / std::acos(-1.0);
    return degrees < 0 ? degrees + 360 : degrees;
  }

 private:
  PlanPlace middle_{0, 0}, along_{1, 0};
  double start_ = 1e300, widest_ = 0;
};

}  // namespace talus::drawing
