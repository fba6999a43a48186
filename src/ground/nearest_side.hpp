// SPDX-License-Identifier: MIT
#pragma once
// How far a place is from a side of an element: a segment in 2D, a triangle in 3D.

#include <vector>

#include "base/vec.hpp"

namespace talus::ground {

/// A ball round something [m].
template <int D>
struct Ball {
  Vec<D> centre{};
  double radius = 0;
};

/// A side with the number of what holds on it.
template <int D>
struct LabelledSide {
  std::array<Vec<D>, D> corners{};  ///< [m]
  int label = 0;
  Ball<D> ball;
};

template <int D>
LabelledSide<D> make_labelled_side(const std::array<Vec<D>, D>& corners, int label);

/// Shortest distance of `x` from the side [m].
template <int D>
double find_distance(const std::array<Vec<D>, D>& corners, const Vec<D>& x);

/// The labels of the sides nearest to a place, all that are as near to a tolerance.
struct NearestSides {
  double distance = 0;  ///< [m]
  std::vector<int> labels;
};

/// Sides that are asked for the nearest one again and again; neighbours should follow one another.
template <int D>
class SideSet {
 public:
  explicit SideSet(std::vector<LabelledSide<D>> sides);
  bool is_empty() const { return sides_.empty(); }
  /// `guess`: number of a side that may be near; left at a nearest one. Not to be asked when empty.
  NearestSides find_nearest(const Vec<D>& x, double tolerance, std::size_t& guess) const;
  /// Labels of the sides whose balls a line through `x` along `axis` meets.
  std::vector<int> find_on_line(const Vec<D>& x, std::size_t axis) const;

 private:
  std::vector<LabelledSide<D>> sides_;
  std::vector<Ball<D>> groups_;  ///< balls round `group_size` sides
};

}  // namespace talus::ground
