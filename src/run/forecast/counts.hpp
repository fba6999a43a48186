// SPDX-License-Identifier: MIT
#pragma once
// How many elements a mesh will have, before it is made.

#include "mesh/plan.hpp"

namespace talus::run {

struct ElementCount {
  double all = 0, soil = 0;
};

/// Elements of a plan in its box and in its polygons, as the mesher makes them: as many as regular ones of the asked
/// size. Refinements are integrated over a grid of 200 by 200 places. Zero for a ready mesh.
ElementCount count_elements(const mesh::Plan& plan);

/// Smallest element size that the plan asks for [m].
double find_smallest_size(const mesh::Plan& plan);

/// Returns true where a coarse mesh of the section takes about a second. Gmsh takes minutes for thousands of corners
/// that lie nearer together than the elements are large.
bool is_meshed_in_a_moment(const mesh::Plan& plan);

}  // namespace talus::run
