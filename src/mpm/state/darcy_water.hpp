// SPDX-License-Identifier: MIT
#pragma once
// Pore water of the Darcy (u-p) formulation (docs/theory/22-mixture.md) as plain data: nodal pressures, contents of
// nodes and elements, and the coefficients of one step. Pressure is positive in tension.

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "base/aligned.hpp"
#include "base/lane.hpp"
#include "base/vec.hpp"
#include "mesh/mesh.hpp"

namespace talus::mpm {

/// Smallest pore volume of a wet point as a fraction of its volume [-]: with smoothing, a point's volume may fall below
/// that of its grains, while its water stays.
inline constexpr double smallest_porosity = 1e-3;
template <class T>
TALUS_KERNEL T find_pores(T volume, T grains) {
  return lane_max(volume - grains, smallest_porosity * volume);
}

/// Place of component `d` of entry `n` in slices of `width` nodes.
template <int D, int width>
TALUS_KERNEL std::size_t find_component(int n, int d) {
  const auto entry = static_cast<unsigned>(n);
  return static_cast<std::size_t>(entry / width) * (D * width) + static_cast<unsigned>(d) * width + entry % width;
}

/// Graph of the mesh for the pressure equation: the elements around each node, and the matrix rows of nodes that share
/// an element. It follows from the mesh alone, in the order of its elements, so sums over it do not depend on threads.
template <int D>
struct NodeGraph {
  // Touches and matrix rows are stored in slices of lane_width consecutive nodes: the first items of these nodes, then
  // their second ones. Those of node i: start[i], start[i] + stride … end(i). The lists of starts have one item more,
  // the number of all items, so that start[i + lane_width] is the end of the longest list of the slice of i.

  // Touch t is element `element[t]`, in which the node is local node `local[t]`. Gaps after short lists repeat the
  // first touch of the node, with zero gradient.
  std::vector<int> touch_start, touch_ends, element, local;
  std::vector<int> corner;         ///< [touch]: find_corner() of the element's node
  AlignedVector<double> gradient;  ///< [touch] ∇N of the node in the element, by find_component() [1/m]
  AlignedVector<int> nodes;        ///< [D+1][lane]: nodes of the elements; 0 in lanes without element
  std::size_t lanes = 0;           ///< number of elements, rounded up to whole blocks
  std::vector<double> size;        ///< h_i, size of the elements around a node (T22.7) [m]
  // The first entry of a row is the diagonal. Gaps after short rows have the node itself as column.
  std::vector<int> row_start, row_ends, column;
  std::vector<int> place;  ///< [touch][D+1]: entry of the row whose column is that node of the element

  static constexpr int row_stride = lane_width, touch_stride = lane_width;
  int row_end(int i) const { return row_ends[i]; }
  int touch_end(int i) const { return touch_ends[i]; }
  /// Place of local node `k` of element `e` in arrays [D+1][lane].
  std::size_t find_corner(int e, int k) const {
    return static_cast<std::size_t>(k) * lanes + static_cast<std::size_t>(e);
  }

  // For the nodes of T from `i` on, which start a slice or are one node, and their touches from `t` on:
  /// End of the touches of the node, or of the longest list of the slice.
  template <class T>
  int find_touch_end(int i) const {
    return LaneTraits<T>::width == 1 ? touch_ends[i] : touch_start[i + LaneTraits<T>::width];
  }
  /// Returns in which lanes the touches are no gaps.
  template <class T>
  TALUS_KERNEL MaskOf<T> are_touches(int i, int t) const {
    return LaneTraits<T>::width == 1 ? MaskOf<T>(true) : are_above<T>(&touch_ends[i], t + LaneTraits<T>::width - 1);
  }
  template <class T>
  TALUS_KERNEL T gather_element(const auto& field, int t) const {
    return gather<T>(field.data(), &element[t]);
  }
  template <class T>
  TALUS_KERNEL T gather_corner(const auto& field, int t) const {
    return gather<T>(field.data(), &corner[t]);
  }
  template <class T>
  TALUS_KERNEL void load_gradient(const mesh::Mesh<D>&, int t, T* b) const {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) b[d] = load_unaligned<T>(&gradient[find_component<D, lane_width>(t, d)]);
  }
};

template <int D>
NodeGraph<D> make_node_graph(const mesh::Mesh<D>& mesh);

/// Work arrays that a step keeps for the next one. A copy of the body starts without them.
struct WorkArrays {
  std::shared_ptr<void> arrays;

  WorkArrays() = default;
  WorkArrays(const WorkArrays&) {}
  WorkArrays(WorkArrays&&) = default;
  WorkArrays& operator=(const WorkArrays& other) {
    if (this != &other) arrays.reset();
    return *this;
  }
  WorkArrays& operator=(WorkArrays&&) = default;
  ~WorkArrays() = default;
};

template <int D>
struct DarcyWater {
  std::shared_ptr<const NodeGraph<D>> graph;  ///< made by the first step

  bool is_used = false;  ///< the nodal sums are those of one velocity

  // By node, kept from step to step.
  std::vector<double> pressure;      ///< [Pa]; NaN where there is no water
  std::vector<std::uint8_t> ponded;  ///< ponding or outflow at zero pressure
  std::vector<double> own;           ///< o_i, water beside the part of the elements (T22.2) [m³]

  // By element. Pores and volume are stored by material, [material][element].
  std::vector<AlignedVector<double>> pores;              ///< of wet points [m³]
  std::vector<AlignedVector<double>> volume;             ///< V̄ of wet points [m³]
  AlignedVector<double> water;                           ///< water of the points, at the density of zero pressure [m³]
  AlignedVector<double> share;                           ///< water lost per pore volume in a step (T22.6) [-]
  AlignedVector<double> saturated, effective, coupling;  ///< Σ V S, Σ V χ, Σ V √(Sχ) [m³]
  AlignedVector<double> conductive;                      ///< Σ V k k_r/(ρ_w g) [m⁵/(N s)]
  AlignedVector<double> soft;                            ///< τ Σ V [m³/Pa]
  AlignedVector<double> pressing;                        ///< Σ V χ p̄ [N m]
  std::array<AlignedVector<double>, D> flux;  ///< Darcy flux relative to the grains, at the end of the step [m/s]
  AlignedVector<double> drawn;                ///< root uptake of this step [m³]
  AlignedVector<double> own_mass;             ///< Σ m N_k² of the points, by corner (T22.3) [kg]

  // By node.
  std::vector<std::vector<double>> node_pores;  ///< [material][node] [m³]
  std::vector<double> node_water;               ///< [m³]
  std::vector<double> change, out, passed;  ///< δ [Pa]; water that leaves the node, and of it through the surface [m³]
  std::vector<Vec<D>> velocity, acceleration;  ///< predicted [m/s], [m/s²]
  std::vector<double> mobility;                ///< Δt² s/(β M), see T22.3 [s²/kg]
  std::vector<Vec<D>> pore_force;              ///< pressure forces that the nodal sums contain [N]
  std::vector<Vec<D>> area;                    ///< of the open sides that touch the node, outwards [m²]

  WorkArrays work;                 ///< of the pressure equation
  int rounds = 0, iterations = 0;  ///< of the last step: linear solutions, and iterations in total
};

}  // namespace talus::mpm
