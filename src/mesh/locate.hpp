// SPDX-License-Identifier: MIT
#pragma once
// In which element a point of space lies.

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// A point counts as inside an element when no shape function is below minus this: roundings of coordinates of a
/// kilometre.
inline constexpr double inside_tolerance = 1e-10;

/// The element of a finished mesh that holds `x` [m], found by walking from element `start` across the side that the
/// point lies beyond, and by looking at every element when the walk leaves the mesh or turns in a circle.
/// -1 when no element holds it. A point on a shared side belongs to the first element met.
template <int D>
int find_element(const Mesh<D>& mesh, const typename Mesh<D>::Point& x, int start = 0);

}  // namespace talus::mesh
