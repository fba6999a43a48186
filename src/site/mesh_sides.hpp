// SPDX-License-Identifier: MIT
#pragma once
// Named sides and lines of a mesh: adjoining elements, normals, and distances from sides.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "mesh/mesh.hpp"

namespace talus::site {

/// Returns the sides of that name. Throws Error (wrong_input), with the names that exist, if there are none.
template <int D>
const std::vector<typename mesh::Mesh<D>::Side>& find_sides(const mesh::Mesh<D>& mesh, const std::string& name);

/// An element that has all nodes of a side, with the local node opposite the side.
struct SideElement {
  int element, opposite;
};

/// Elements per side, by the nodes of the side in increasing order.
template <int D>
using SideMap = std::map<std::array<int, D>, std::vector<SideElement>>;

template <int D>
SideMap<D> map_sides(const mesh::Mesh<D>& mesh, const std::vector<typename mesh::Mesh<D>::Side>& wanted);

/// Returns the unit normal of the side opposite local node k, directed out of the element, and the area of the side [m,
/// m²].
template <int D>
std::pair<Vec<D>, double> find_outward_normal(const mesh::Mesh<D>& mesh, int e, int k);

// Distance of a point from a side of an element: a segment in 2D, a triangle in 3D.

/// A bounding ball [m].
template <int D>
struct Ball {
  Vec<D> centre{};
  double radius = 0;
};

/// A side with the number of its condition.
template <int D>
struct LabelledSide {
  std::array<Vec<D>, D> corners{};  ///< [m]
  int label = 0;
  Ball<D> ball;
};

template <int D>
LabelledSide<D> make_labelled_side(const std::array<Vec<D>, D>& corners, int label);

/// Returns the shortest distance of `x` from the side [m].
template <int D>
double find_distance(const std::array<Vec<D>, D>& corners, const Vec<D>& x);

/// The distance of the nearest side of a point, and the labels of all sides at that distance within a tolerance.
struct NearestSides {
  double distance = 0;  ///< [m]
  std::vector<int> labels;
};

/// Sides for repeated searches of the nearest one; fastest if neighbouring sides follow one another.
template <int D>
class SideSet {
 public:
  explicit SideSet(std::vector<LabelledSide<D>> sides);
  bool is_empty() const { return sides_.empty(); }
  /// Returns the nearest sides; the set must not be empty. `guess`: index of a side that may be near; set to a nearest
  /// one.
  NearestSides find_nearest(const Vec<D>& x, double tolerance, std::size_t& guess) const;
  /// Returns the labels of the sides whose balls are intersected by the line through `x` along `axis`.
  std::vector<int> find_on_line(const Vec<D>& x, std::size_t axis) const;

 private:
  std::vector<LabelledSide<D>> sides_;
  std::vector<Ball<D>> groups_;  ///< bounding balls of `group_size` sides each
};

}  // namespace talus::site
