// SPDX-License-Identifier: MIT
#pragma once
// A function of the plane from its values at scattered points.

#include <array>
#include <vector>

#include "mesh/mesh.hpp"

namespace talus::mesh {

enum class Scatter { linear, thin_plate };

/// A value at a point [m].
struct ScatteredValue {
  std::array<double, 2> at{};
  double value = 0;
};

/// Interpolates scattered values: linearly on the Delaunay triangles of the points (about their mean where more than
/// three lie on one circle, as in each cell of a regular grid), or by the thin plate spline
/// f = a + b x + c y + Σ w_i r_i² ln r_i with Σ w_i = Σ w_i x_i = Σ w_i y_i = 0 (Duchon 1977). Both reproduce linear
/// functions. Immutable.
class ScatteredField {
 public:
  /// Largest number of points of the spline, whose dense equations take n³ operations.
  static constexpr std::size_t most_spline_points = 2000;

  /// Throws Error (wrong_input) with one sentence if there are fewer than three points, too many for a spline, two
  /// points at one place, or points on one line.
  ScatteredField(const std::vector<ScatteredValue>& values, Scatter kind);

  /// Returns the value at a point. Beyond the triangles the linear interpolation continues to the value of the nearest
  /// point in each corner of a frame, ten times as large as the extent of the points.
  double find(const std::array<double, 2>& x) const;

  /// Returns true if the point lies within the convex hull of the points.
  bool covers(const std::array<double, 2>& x) const;

  Scatter kind() const { return kind_; }
  /// Returns the triangles of the points and of the frame, and the values at their nodes. The nodes are the points, the
  /// corners of the frame, and the mean of each set of more than three points on one circle.
  const Mesh<2>& triangles() const { return mesh_; }
  const std::vector<double>& values() const { return values_; }

 private:
  double find_on_plate(const std::array<double, 2>& x) const;
  void make_plate(const std::vector<ScatteredValue>& values);

  Scatter kind_;
  Mesh<2> mesh_;
  std::vector<double> values_;               ///< of the nodes of the mesh
  std::vector<std::array<double, 2>> hull_;  ///< counter-clockwise
  std::array<double, 2> origin_{};           ///< of the scaled coordinates of the spline
  double scale_ = 1;
  std::vector<std::array<double, 2>> centres_;  ///< scaled
  std::vector<double> weights_;                 ///< of the centres, then a, b, c
};

}  // namespace talus::mesh
