// SPDX-License-Identifier: MIT
#pragma once
// The column of soil above a point: the integral behind the initial vertical stress of a K0 state.

#include "mesh/mesh.hpp"

namespace talus::mesh {

/// A point by its element and its local coordinates in it.
template <int D>
struct LocalPoint {
  int element;
  std::array<double, D> xi;
};

/// ∫ weight ds along the straight line from each point in direction `up` (a unit vector) to the end of the mesh, with
/// `element_weight` constant in each element: zero where empty, unit weight [N/m³] for the overburden [Pa].
/// The line walks from element to element through their sides; it passes over empty elements and over gaps of the
/// mesh and goes on in what lies above. A line that meets a node or an edge, where the next element is not unique, is
/// walked again from a place moved by 1e-9 of the element, so points on the border of the mesh are allowed.
/// The result is the same for any number of threads.
template <int D>
std::vector<double> overburden_integral(const Mesh<D>& mesh, const std::vector<double>& element_weight,
                                        const std::vector<LocalPoint<D>>& points, const typename Mesh<D>::Point& up,
                                        int threads = 1);

}  // namespace talus::mesh
