// SPDX-License-Identifier: MIT
#pragma once
// Mirror image of a section and of what is searched in it. Where the factor has kinks or two near minima, a search
// amplifies rounding; a slope and its mirror image are therefore searched as one section.

#include "lem/search/search.hpp"
#include "lem/search/trial_circles.hpp"

namespace talus::lem {

/// Returns true if the mirror image of a section is searched in its place: the ground is higher on the left; where
/// neither side is higher, the soil is heavier or stronger, the water or the load higher, or the bars are more on the
/// left. The order of regions and points has no effect.
bool is_searched_reflected(const Section& section);

/// Reflection of a section to one that begins at x = 0. Coordinates are rounded to twelve digits, so that a section
/// drawn from x = 0 and the reflection of its mirror image, wherever that lies, are bitwise identical.
class Reflection {
 public:
  explicit Reflection(const Section& section);

  Section reflect(const Section& section) const;
  SearchOptions reflect(SearchOptions options) const;
  EntryExitSearch reflect(EntryExitSearch ranges) const;
  GridSearch reflect(GridSearch grid) const;
  /// Not rounded: the reflection of a reflected surface.
  Surface reflect(Surface surface) const;
  TrialCircles reflect(TrialCircles circles) const;

 private:
  double turn(double x) const;
  std::array<double, 2> turn(const std::array<double, 2>& range) const { return {turn(range[1]), turn(range[0])}; }
  void turn(std::vector<Point>& line) const;
  void turn_line(std::vector<Point>& line) const;
  void turn_grid(PressureGrid& grid) const;

  double sum_;   ///< of the x of a point and of its image [m]
  double unit_;  ///< coordinates are multiples of 1/unit [1/m]
};

}  // namespace talus::lem
