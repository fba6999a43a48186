// SPDX-License-Identifier: MIT
#include "mesh/neighbours.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace talus::mesh {
namespace {

/// One side seen from one element.
template <int D>
struct HalfSide {
  std::array<int, D - 1> others;  ///< its nodes but the lowest, ascending
  int element;
  int opposite;  ///< the local node that the side does not hold
};

/// The nodes of the side of `element` opposite local node `k`, ascending.
template <int D>
std::array<int, D> sort_side(const typename Mesh<D>::Element& element, int k) {
  std::array<int, D> side;
  for (int i = 0, j = 0; i <= D; ++i)
    if (i != k) side[j++] = element[i];
  std::sort(side.begin(), side.end());
  return side;
}

}  // namespace

template <int D>
std::vector<typename Mesh<D>::Element> find_neighbours(const Mesh<D>& mesh) {
  // Counting sort by the lowest node: about two dozen half sides a node in 3D, four in 2D.
  std::vector<int> start(mesh.nodes.size() + 1, 0);
  for (const auto& element : mesh.elements)
    for (int k = 0; k <= D; ++k) ++start[sort_side<D>(element, k)[0] + 1];
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<HalfSide<D>> halves(mesh.elements.size() * (D + 1));
  std::vector<int> fill(start.begin(), start.end() - 1);
  for (int e = 0; e < mesh.element_count(); ++e)
    for (int k = 0; k <= D; ++k) {
      const auto side = sort_side<D>(mesh.elements[e], k);
      HalfSide<D>& half = halves[fill[side[0]]++];
      std::copy(side.begin() + 1, side.end(), half.others.begin());
      half.element = e;
      half.opposite = k;
    }

  std::vector<typename Mesh<D>::Element> neighbours(mesh.elements.size());
  for (auto& n : neighbours) n.fill(-1);
  for (std::size_t node = 0; node + 1 < start.size(); ++node) {
    const auto begin = halves.begin() + start[node], end = halves.begin() + start[node + 1];
    std::sort(begin, end, [](const HalfSide<D>& a, const HalfSide<D>& b) {
      return a.others != b.others ? a.others < b.others : a.element < b.element;
    });
    for (auto a = begin; a != end;) {
      auto b = a + 1;
      while (b != end && b->others == a->others) ++b;
      if (b - a > 2)
        throw Error(ExitCode::wrong_input,
                    fmt::format("{} elements of the mesh share the side between nodes {} and {}: elements overlap",
                                b - a, node, a->others[0]));
      if (b - a == 2) {
        neighbours[a->element][a->opposite] = (a + 1)->element;
        neighbours[(a + 1)->element][(a + 1)->opposite] = a->element;
      }
      a = b;
    }
  }
  return neighbours;
}

template std::vector<Mesh<2>::Element> find_neighbours<2>(const Mesh<2>&);
template std::vector<Mesh<3>::Element> find_neighbours<3>(const Mesh<3>&);

}  // namespace talus::mesh
