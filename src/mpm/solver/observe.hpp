// SPDX-License-Identifier: MIT
#pragma once
// Read access to a body between steps: single points, sums over the points, and displacements.

#include "mpm/kernels/observation.hpp"

namespace talus::mpm {

template <int D>
bool is_present(const Body<D>& body, int id) {
  return body.points.element[id] >= 0;
}

/// Reads a point that is on the grid. With frozen geometry the displacement is that of the nodes.
template <int D>
PointView<D> view_point(const Body<D>& body, int id);

/// Sets the reference of displacements to the present positions.
template <int D>
void reset_displacements(Body<D>& body);

template <int D>
LargestDisplacement find_largest_displacement(const Body<D>& body);

template <int D>
Totals<D> sum_points(const Body<D>& body, const std::type_identity_t<Vec<D>>& gravity);

template <int D>
WaterState<D> find_water_state(const Body<D>& body);

template <int D>
Observation<D> observe(const Body<D>& body, const std::type_identity_t<Vec<D>>& gravity,
                       const std::vector<int>& points);

// State variables of single points; view_point() reads all of a point.

/// Overwrites the state variables of a point on the grid, in the order of its law. `state` has as many entries as the
/// law has state variables.
template <int D>
void write_state(Body<D>& body, int id, const double* state);

}  // namespace talus::mpm
