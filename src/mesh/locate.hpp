// SPDX-License-Identifier: MIT
#pragma once
// Point location in a mesh, adjacency of elements, and integration along lines through the mesh.

#include "mesh/mesh.hpp"

namespace talus::mesh {

// Adjacency of elements.

/// Returns for every element the elements across the sides opposite its local nodes, -1 at the boundary. Sides are
/// sorted by their lowest node and matched within each short list, which is linear in the number of elements. Throws
/// Error (wrong_input) if more than two elements share a side, which means that elements overlap.
template <int D>
std::vector<typename Mesh<D>::Element> find_neighbours(const Mesh<D>& mesh);

/// A point is inside an element if no shape function is below minus this value, which allows for the rounding of
/// coordinates of kilometres.
inline constexpr double inside_tolerance = 1e-10;

/// Returns the element of a finished mesh that contains `x` [m]; -1 if there is none. The search walks from element
/// `start` across the side beyond which the point lies, and tests every element if the walk leaves the mesh or cycles.
/// A point on a shared side belongs to the first element found.
template <int D>
int find_element(const Mesh<D>& mesh, const typename Mesh<D>::Point& x, int start = 0);

// The overburden above a point, for the initial vertical stress of a K0 state.

/// A point given by its element and local coordinates.
template <int D>
struct LocalPoint {
  int element;
  std::array<double, D> xi;
};

/// Returns ∫ weight ds along the straight line from each point in direction `up` (a unit vector) to the end of the
/// mesh. `element_weight` is constant in each element: zero in empty elements; with the unit weight [N/m³] the result
/// is the overburden [Pa]. The line passes from element to element through their sides, and over empty elements and
/// gaps of the mesh to the elements above. A line that meets a node or an edge, where the next element is not unique,
/// is repeated with a shift of 1e-9 of the element, so points on the boundary of the mesh are allowed. The result does
/// not depend on the number of threads.
template <int D>
std::vector<double> overburden_integral(const Mesh<D>& mesh, const std::vector<double>& element_weight,
                                        const std::vector<LocalPoint<D>>& points, const typename Mesh<D>::Point& up,
                                        int threads = 1);

}  // namespace talus::mesh
