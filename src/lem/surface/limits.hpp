// SPDX-License-Identifier: MIT
#pragma once
// Limits that a user sets to the slip surfaces of a search: areas that they avoid, windows that they pass, direction
// of sliding, and size of the mass; and the lines that they follow.

#include <string>
#include <vector>

#include "lem/section/section.hpp"

namespace talus::lem {

/// A point, a polyline or a box.
struct Window {
  std::string name;
  std::vector<Point> points;  ///< of a box the lower left and the upper right corner [m]
  bool is_box = false;
};

struct SurfaceLimits {
  std::vector<std::vector<Point>> excluded;  ///< polygons whose interior no base enters [m]
  std::vector<Window> passages;              ///< each is met by every base
  double smallest_area = 0;                  ///< of the sliding mass [m²]
  double smallest_weight = 0;                ///< of the sliding mass [N/m]
  int direction = 0;                         ///< of sliding: towards smaller x (-1), larger x (1), or either (0)
};

/// Returns true if a part of the straight line between two points lies inside a polygon, beyond rounding.
bool enters_polygon(const std::vector<Point>& polygon, const Point& a, const Point& b);
/// Returns true if the straight line between two points meets a polyline or a box.
bool meets_window(const Window& window, const Point& a, const Point& b);

/// A thin layer or a line that surfaces follow, as two lines from left to right between the same two x, with the same
/// x of their points [m]. They are equal for a line.
struct Path {
  std::vector<Point> bottom, top;
};

/// Returns the path of the regions that are named by their indices; without points where the regions do not form one
/// layer, which has one thickness at each x and no gaps.
Path make_path(const std::vector<std::vector<Point>>& polygons);

/// Lines between which circles are tangent: two levels, or twice the same side of a layer.
struct TangentLines {
  std::vector<Point> upper, lower;  ///< from left to right [m]
  bool is_level = false;            ///< levels: the deepest point of the circle lies between its ends
};

}  // namespace talus::lem
