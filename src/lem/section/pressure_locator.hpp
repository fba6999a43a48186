// SPDX-License-Identifier: MIT
#pragma once
// Finds the pore pressure at a place in a grid of triangles.

#include <optional>
#include <vector>

#include "lem/section/section.hpp"

namespace talus::lem {

/// Triangles sorted into square buckets: about one triangle is tried per question.
class PressureLocator {
 public:
  PressureLocator() = default;
  explicit PressureLocator(const PressureGrid& grid);

  bool empty() const { return planes_.empty(); }
  /// u, linear in the triangle that holds the place; none outside all triangles [Pa].
  std::optional<double> find(const Point& p) const;

 private:
  /// Pressure and barycentric coordinates of a triangle, linear in the distance from its first corner.
  struct Plane {
    Point corner{};
    Point second{}, third{};                           ///< gradients of the shares of the other two corners [1/m]
    double pressure = 0, to_second = 0, to_third = 0;  ///< at the corner, and how much more there is at the others
  };
  static std::optional<double> read(const Plane& plane, const Point& p);
  std::size_t find_bucket(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  std::vector<Plane> planes_;  ///< in the order of the buckets
  Point low_{};
  double size_ = 1;  ///< side of a bucket [m]
  int columns_ = 0, rows_ = 0;
  std::vector<int> first_;  ///< per bucket, and one more: where its triangles begin
};

}  // namespace talus::lem
