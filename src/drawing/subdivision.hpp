// SPDX-License-Identifier: MIT
#pragma once
// The areas that lines of a drawing enclose where they cross and touch.

#include <string>
#include <vector>

#include "drawing/lines.hpp"

namespace talus::drawing {

/// Distance below which the ends and corners of lines are moved onto other lines, as a fraction of the section.
inline constexpr double snapping_distance = 1e-4;

struct Subdivision {
  /// A corner that was moved onto another line or its corner.
  struct Snap {
    mesh::Point2 at{};
    double gap = 0;  ///< [m]
  };
  /// A part of a line that bounds no area.
  struct Dangle {
    mesh::Point2 end{};  ///< its loose end, if it has one
    double length = 0;   ///< [m]
  };

  std::vector<mesh::Polyline> faces;  ///< outlines; one may lie within another
  std::vector<Snap> snaps;            ///< the largest gap first
  std::vector<Dangle> dangles;        ///< the longest first
};

/// Moves corners within `tolerance` [m] of one another together, and those within it of a line into the line; changes
/// `lines`, and returns the gaps that it closed.
std::vector<Subdivision::Snap> snap_lines(std::vector<mesh::Polyline>& lines, double tolerance);

/// Returns the areas that the lines enclose. Lines meet to `tolerance` [m]. Works in a child process with limited time
/// and memory. Throws Error (wrong_input) with one sentence if that fails or this build has no GDAL.
Subdivision subdivide(const std::vector<Chain>& chains, double tolerance);

}  // namespace talus::drawing
