// SPDX-License-Identifier: MIT
#pragma once
// Arcs between two points of the ground. All arcs through the same two points are nested, so that one number identifies
// an arc: half the angle that it spans, which increases with depth.

#include <optional>
#include <vector>

#include "lem/section/slope.hpp"
#include "lem/slices/solve.hpp"

namespace talus::lem {

/// Range of the half angles with which the arc through two points of the ground is a slip surface [rad].
struct AngleRange {
  double from = 0;  ///< it touches the ground in between, has the smallest depth, or is nearly flat
  double to = 0;    ///< it is vertical at its upper end, or touches the base
  bool to_base = false;
};

/// Returns points just behind the ends of the bars, at most 24 of them spread over all. A surface that just misses the
/// ends is not held by the bars, and its factor has a kink there.
std::vector<Point> list_bar_ends(const Section& section);

class Arcs {
 public:
  /// `composite`: arcs may reach below the bottom of the soil and continue along it.
  /// `tangent`: arcs are restricted to those between the tangents to its lines.
  Arcs(const Slope& slope, double smallest_depth, bool composite,
       const std::optional<TangentLines>& tangent = std::nullopt);

  /// Returns the range for the ends left < right; none if no arc fits.
  std::optional<AngleRange> find_range(double left, double right) const;
  Surface make_arc(double left, double right, double half_angle) const;
  /// Returns the half angle at which the arc first touches a region from above; none if it does not between the ends.
  std::optional<double> find_touch(double left, double right, const Region& region) const;
  /// Returns the largest vertical depth under the ground [m].
  double find_depth(double left, double right, double half_angle) const;
  /// Regions that circles are tied to: those of the section, one below the base for composite circles, and the points
  /// just behind the ends of bars.
  const std::vector<Region>& regions() const { return regions_; }
  /// Returns the half angle of a given arc.
  static double measure_half_angle(const Surface& arc);

  bool has_tangent() const { return tangent_.has_value(); }

 private:
  /// Restricts a range to the tangents; returns false if nothing remains.
  bool restrict_to_tangents(double left, double right, double steepness, AngleRange& range) const;

  const Slope* slope_;
  double smallest_depth_;
  bool composite_;
  std::vector<Region> regions_;
  std::optional<TangentLines> tangent_;
  Region upper_, lower_;  ///< the lines of the tangents, closed
};

}  // namespace talus::lem
