// SPDX-License-Identifier: MIT
#pragma once
// How the polygons of a plan cover the section: where two of them lie over one another, and where soil misses a piece.

#include <vector>

#include "mesh/plan.hpp"
#include "mesh/planar.hpp"

namespace talus::mesh {

/// A connected piece of the plane.
struct Piece {
  double area = 0;       ///< [m²]
  double width = 0;      ///< its area over half the length of its outline [m]
  Point2 place{};        ///< a point inside [m]
  Point2 low{}, high{};  ///< corners of the rectangle around it [m]
};

/// A place where the polygons do not fit one another.
struct Misfit {
  enum class Kind {
    same,     ///< two polygons cover the same
    overlap,  ///< two polygons overlap, and neither lies inside the other
    gap,      ///< no polygon covers a piece that has soil above and below it
  };
  Kind kind = Kind::overlap;
  std::vector<int> polygons;  ///< the two of an overlap; those that a gap touches
  double area = 0;            ///< of all pieces [m²]
  int pieces = 0;
  Piece largest;
};

/// Lengths below this are taken as zero where polygons meet: a millionth of the larger side of the box [m].
double get_section_tolerance(const Plan& plan);

/// Overlaps in the order of the polygons, then gaps from the largest to the smallest. The polygons must be simple.
/// Areas are exact for corners on a grid of a billionth of the section; pieces that are narrower than a tenth of the
/// tolerance are none.
std::vector<Misfit> find_misfits(const Plan& plan);

/// A corner that was moved onto one or an edge of another polygon.
struct Joined {
  std::string name;  ///< of the polygon or line
  Point2 from{}, to{};
};

/// Moves corners of polygons and points of lines that miss a corner, an edge or a side of the box by less than
/// get_section_tolerance() onto it, and tells which. Distances that are rounding errors (a billionth of the box) stay.
std::vector<Joined> join_corners(Plan& plan);

}  // namespace talus::mesh
