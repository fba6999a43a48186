// SPDX-License-Identifier: MIT
#pragma once
// Cover of a section by the polygons of a plan: overlaps, gaps, and the joining of corners that nearly coincide.

#include <vector>

#include "mesh/plan.hpp"
#include "mesh/planar.hpp"

namespace talus::mesh {

/// A connected part of the plane.
struct Piece {
  double area = 0;       ///< [m²]
  double width = 0;      ///< area over half the length of the outline [m]
  Point2 place{};        ///< a point inside [m]
  Point2 low{}, high{};  ///< corners of the bounding rectangle [m]
};

/// An overlap or a gap of polygons.
struct Misfit {
  enum class Kind {
    same,     ///< two polygons cover the same area
    overlap,  ///< two polygons overlap partly
    gap,      ///< an area without polygon that has soil above and below
  };
  Kind kind = Kind::overlap;
  std::vector<int> polygons;  ///< the two of an overlap; those adjacent to a gap
  double area = 0;            ///< sum over all pieces [m²]
  int pieces = 0;
  Piece largest;
};

/// Returns the length below which distances between polygons count as zero, 1e-6 of the larger side of the box [m].
double get_section_tolerance(const Plan& plan);

/// Returns overlaps in the order of the polygons, then gaps by decreasing size. The polygons must be simple. Areas are
/// exact for corners on a grid of 1e-9 of the section; pieces narrower than a tenth of the tolerance are ignored.
std::vector<Misfit> find_misfits(const Plan& plan);

/// A corner that was moved onto a corner or an edge of another polygon.
struct Joined {
  std::string name;  ///< name of the polygon or line
  Point2 from{}, to{};
};

/// Moves corners of polygons and points of lines that are within get_section_tolerance() of a corner, an edge or a side
/// of the box onto it, and returns them. Distances within rounding errors (1e-9 of the box) are ignored. Corners of a
/// polygon that then coincide are one; of a polygon narrower than the tolerance fewer than three may remain.
std::vector<Joined> join_corners(Plan& plan);

}  // namespace talus::mesh
