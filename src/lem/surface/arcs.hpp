// SPDX-License-Identifier: MIT
#pragma once
// Arcs between two points of the ground. All arcs through the same two points are nested, so one number says which:
// half the angle that the arc spans. It grows with depth.

#include <optional>
#include <vector>

#include "lem/section/slope.hpp"
#include "lem/slices/solve.hpp"

namespace talus::lem {

/// Half angles between which the arc through two points of the ground is a slip surface [rad].
struct AngleRange {
  double from = 0;  ///< it touches the ground in between, is as deep as the smallest depth, or nearly flat
  double to = 0;    ///< it stands upright at its upper end, or touches the base
  bool to_base = false;
};

class Arcs {
 public:
  /// `composite`: arcs may go below the base and are cut level there.
  Arcs(const Slope& slope, double smallest_depth, bool composite);

  /// None when no arc fits between these two x, left < right.
  std::optional<AngleRange> find_range(double left, double right) const;
  Surface make_arc(double left, double right, double half_angle) const;
  /// The half angle at which the arc comes to touch a region from above; none when it never does between the ends.
  std::optional<double> find_touch(double left, double right, const Region& region) const;
  /// Largest vertical depth under the ground [m].
  double find_depth(double left, double right, double half_angle) const;
  /// What circles may come to touch: the section's regions, and the base where composite circles run on below it.
  const std::vector<Region>& regions() const { return regions_; }
  /// Half angle of an arc that was made elsewhere.
  static double measure_half_angle(const Surface& arc);

 private:
  const Slope* slope_;
  double smallest_depth_;
  bool composite_;
  std::vector<Region> regions_;
};

}  // namespace talus::lem
