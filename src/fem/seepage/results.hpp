// SPDX-License-Identifier: MIT
#pragma once
// Results of seepage from the heads of a solution. Internal to fem/.

#include "fem/seepage/newton.hpp"
#include "mesh/mesh.hpp"

namespace talus::fem {

// The contour of zero pore pressure in a plane field.

/// Returns polylines [m] along which the nodal pressure (linear in elements of soil) changes from at most zero to above
/// it. Open lines start at their end with the smaller x; closed ones repeat their first point.
std::vector<std::vector<std::array<double, 2>>> find_water_table(const mesh::Mesh<2>& mesh,
                                                                 const std::vector<double>& pressure);

/// Returns the flow through boundaries, roots and stores, without the fields. `sums` belong to the solution,
/// `conditions` and `input` to the solve.
template <int D>
SeepageResult<D> make_flow_result(const SeepageSystem<D>& system, const SeepageState& state, const NodalSums& sums,
                                  const std::vector<NodeCondition>& conditions, double time, const StepInput& input);

/// Adds heads, pressures, saturations, velocities, wet faces and water table of the solution.
template <int D>
void add_fields(const SeepageSystem<D>& system, const SeepageState& state, const StepInput& input,
                SeepageResult<D>& result);

/// Convert heads per node to heads per unknown, and back; nodes without soil get their elevation.
template <int D>
std::vector<double> to_unknowns(const SeepageSystem<D>& system, const std::vector<double>& node_heads);
template <int D>
std::vector<double> to_nodes(const SeepageSystem<D>& system, const std::vector<double>& heads);

}  // namespace talus::fem
