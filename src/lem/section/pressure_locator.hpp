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

  bool empty() const { return grid_.triangles.empty(); }
  /// u, linear in the triangle that holds the place; none outside all triangles [Pa].
  std::optional<double> find(const Point& p) const;

 private:
  std::optional<double> read(std::size_t triangle, const Point& p) const;
  std::size_t find_bucket(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  PressureGrid grid_;
  Point low_{};
  double size_ = 1;  ///< side of a bucket [m]
  int columns_ = 0, rows_ = 0;
  std::vector<int> first_;  ///< per bucket, and one more: where its triangles begin
  std::vector<int> triangles_;
};

}  // namespace talus::lem
