// SPDX-License-Identifier: MIT
#pragma once
// The parts into which lines divide a triangle. A function that is linear in each part, and may jump from one to the
// next, has its extremes at their corners.

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "mesh/planar.hpp"

namespace talus::run {

/// Barycentric coordinates in a triangle.
using Weights = std::array<double, 3>;

/// Fraction of the size of a triangle by which its points lie inside the parts, on whose sides strength and pressure
/// may jump: more than the rounding of the coordinates of a mesh.
inline constexpr double inwards = 1e-6;

class KinkPoints {
 public:
  using Triangle = std::array<Vec<2>, 3>;
  struct Segment {
    Vec<2> from{}, to{};
  };

  explicit KinkPoints(const std::vector<mesh::Polyline>& lines);

  /// Returns one point inside each corner of each part of a triangle, near the corner; nothing where no line divides
  /// it.
  std::vector<Weights> list(const Triangle& triangle) const;

 private:
  void add_places(const Triangle& triangle, int divisions, std::vector<Vec<2>>& places) const;
  std::vector<Segment> list_inside(const Triangle& triangle, double tolerance) const;
  std::array<std::size_t, 2> find_cell(const Vec<2>& x) const;

  std::vector<Segment> segments_;
  Vec<2> low_{}, cell_{1, 1};
  std::vector<std::vector<std::size_t>> at_;  ///< by cell of a grid, the segments whose box touches it
};

}  // namespace talus::run
