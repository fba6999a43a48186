// SPDX-License-Identifier: MIT
#pragma once
// Named sides and lines of a mesh: the elements beside them, their normals, and those of their nodes.

#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/vec.hpp"
#include "mpm/body/body.hpp"

namespace talus::ground {

/// Throws Error (wrong_input) for a side that the mesh does not have, with the names it has.
template <int D>
const std::vector<typename mesh::Mesh<D>::Side>& find_sides(const mesh::Mesh<D>& mesh, const std::string& name);

/// Elements at a side: those that contain all its nodes, with the local node that lies opposite.
struct SideElement {
  int element, opposite;
};

/// By the side's nodes in increasing order.
template <int D>
using SideMap = std::map<std::array<int, D>, std::vector<SideElement>>;

template <int D>
SideMap<D> map_sides(const mesh::Mesh<D>& mesh, const std::vector<typename mesh::Mesh<D>::Side>& wanted);

/// Unit normal of the element's side opposite local node k, out of the element; and the side's area [m, m²].
template <int D>
std::pair<Vec<D>, double> find_outward_normal(const mesh::Mesh<D>& mesh, int e, int k);

/// Normal of a wall, out of the soil: away from the element that holds soil, or else along gravity.
template <int D>
Vec<D> find_wall_normal(const mpm::Body<D>& body, const std::vector<SideElement>& elements,
                        const std::type_identity_t<Vec<D>>& gravity);

/// Normals at each node of the named sides, those of one smooth line averaged.
template <int D>
std::map<int, std::vector<Vec<D>>> find_node_normals(const mpm::Body<D>& body,
                                                     const std::vector<typename mesh::Mesh<D>::Side>& sides,
                                                     const std::type_identity_t<Vec<D>>& gravity);

/// Adds a direction to those that are fixed (`count` of them, orthonormal); nothing when it lies among them already.
template <int D>
void add_direction(Vec<D> (&fixed)[D], int& count, std::type_identity_t<Vec<D>> direction);

// How far a place is from a side of an element: a segment in 2D, a triangle in 3D.

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
