// SPDX-License-Identifier: MIT
#pragma once
// The background mesh of linear triangles (D = 2) or tetrahedra (D = 3), as plain arrays, and its finishing.

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/portable.hpp"

namespace talus::mesh {

/// Region number of an element without soil in the initial state.
inline constexpr int empty_region = -1;

/// A mesh of linear simplices. Local node 0 is the origin of the local coordinates; ξ_k = N_k for k = 1..D.
template <int D>
struct Mesh {
  using Point = std::array<double, D>;
  using Element = std::array<int, D + 1>;
  using Side = std::array<int, D>;  ///< nodes of an edge (2D) or a triangle (3D)

  std::vector<Point> nodes;                        ///< coordinates [m]
  std::vector<Element> elements;                   ///< node numbers; positive orientation
  std::vector<int> element_region;                 ///< index into region_names, or empty_region
  std::vector<std::string> region_names;           ///< names of the soil polygons or physical groups
  std::map<std::string, std::vector<Side>> sides;  ///< named boundary sides and lines

  // Derived by finish().
  std::vector<Element> neighbours;  ///< element across the side opposite local node k; -1 at the boundary
  std::vector<double> volumes;      ///< area [m²] per metre of thickness (2D) or volume [m³]
  std::vector<std::array<double, D * D>> gradients;  ///< [k*D+d] = ∂ξ_{k+1}/∂x_d [1/m]
  std::vector<double> altitudes;                     ///< smallest altitude of each element [m], L_min of (2.84)

  int node_count() const { return static_cast<int>(nodes.size()); }
  int element_count() const { return static_cast<int>(elements.size()); }
};

/// Numbering of elements and nodes by finish().
enum class Order {
  space_filling,  ///< elements along a Morton curve, nodes by first use; unused nodes are removed
  as_given        ///< numbers are kept; two nodes of an inverted element are exchanged
};

/// Orients the elements, renumbers elements, nodes and sides (according to `order`) and computes the derived data.
/// Throws Error (wrong_input) if an element has no volume, elements overlap, or a node number does not exist.
template <int D>
void finish(Mesh<D>& mesh, Order order = Order::space_filling);

/// Returns the coordinates [m] of the point with local coordinates `xi` in element `e`.
template <int D>
std::array<double, D> to_global(const Mesh<D>& mesh, int e, const typename Mesh<D>::Point& xi);

/// Returns the local coordinates of the global point `x` [m] in element `e` (outside the element some N are negative).
template <int D>
std::array<double, D> to_local(const Mesh<D>& mesh, int e, const typename Mesh<D>::Point& x);

// The same for any mesh type M, this one or that on a GPU.

template <class M, std::size_t D>
TALUS_PORTABLE std::array<double, D> find_place(const M& mesh, int e, const std::array<double, D>& xi) {
  const auto& element = mesh.elements[e];
  std::array<double, D> x = mesh.nodes[element[0]];
  for (std::size_t k = 0; k < D; ++k)
    for (std::size_t d = 0; d < D; ++d) x[d] += xi[k] * (mesh.nodes[element[k + 1]][d] - mesh.nodes[element[0]][d]);
  return x;
}
template <class M, std::size_t D>
TALUS_PORTABLE std::array<double, D> find_local(const M& mesh, int e, const std::array<double, D>& x) {
  const auto& origin = mesh.nodes[mesh.elements[e][0]];
  std::array<double, D> xi{};
  for (std::size_t k = 0; k < D; ++k)
    for (std::size_t d = 0; d < D; ++d) xi[k] += mesh.gradients[e][k * D + d] * (x[d] - origin[d]);
  return xi;
}

// The gradient of a linear shape function is minus the normal of the side opposite its node, divided by the altitude.

/// Returns ∇N_k [1/m] of local node `k` in element `e` of a finished mesh, this one or that on a GPU.
template <template <int> class M, int D>
TALUS_PORTABLE std::array<double, D> find_shape_gradient(const M<D>& mesh, int e, int k) {
  const std::array<double, D* D>& g = mesh.gradients[static_cast<std::size_t>(e)];
  std::array<double, D> gradient{};
  for (std::size_t d = 0; d < D; ++d) {
    if (k > 0) {
      gradient[d] = g[static_cast<std::size_t>(k - 1) * D + d];
    } else {
      for (std::size_t j = 0; j < D; ++j) gradient[d] -= g[j * D + d];
    }
  }
  return gradient;
}

}  // namespace talus::mesh
