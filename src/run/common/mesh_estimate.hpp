// SPDX-License-Identifier: MIT
#pragma once
// Estimates of a mesh from its plan, without meshing.

#include "mesh/plan.hpp"

namespace talus::run {

struct ElementCount {
  double all = 0, soil = 0;
};

/// Estimates the number of elements of a plan in its box and in its polygons, from the area or volume of elements of
/// the requested size. Refinements are integrated over a grid of 200 by 200 points. Zero for a mesh from a file.
ElementCount count_elements(const mesh::Plan& plan);

/// Smallest element size of the plan [m].
double find_smallest_size(const mesh::Plan& plan);

/// Returns true if a coarse mesh of the section takes about a second. Gmsh takes minutes for thousands of corners
/// whose distances are smaller than the elements.
bool is_meshed_in_a_moment(const mesh::Plan& plan);

}  // namespace talus::run
