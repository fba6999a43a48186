// SPDX-License-Identifier: MIT
#pragma once
// In which element a point of space lies.

#include "mesh/mesh.hpp"

namespace talus::mesh {

// Which element lies across which side.

/// For every element the elements across the sides opposite its local nodes, -1 where the mesh ends.
/// Sides are sorted by their lowest node and matched within each short list: linear in the number of elements.
/// Throws Error (wrong_input) when more than two elements share a side, which means that elements overlap.
template <int D>
std::vector<typename Mesh<D>::Element> find_neighbours(const Mesh<D>& mesh);

/// A point counts as inside an element when no shape function is below minus this: roundings of coordinates of a
/// kilometre.
inline constexpr double inside_tolerance = 1e-10;

/// The element of a finished mesh that holds `x` [m], found by walking from element `start` across the side that the
/// point lies beyond, and by looking at every element when the walk leaves the mesh or turns in a circle.
/// -1 when no element holds it. A point on a shared side belongs to the first element met.
template <int D>
int find_element(const Mesh<D>& mesh, const typename Mesh<D>::Point& x, int start = 0);

// The column of soil above a point: the integral behind the initial vertical stress of a K0 state.

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
