// SPDX-License-Identifier: MIT
#pragma once
// From the heads of a solution to what users read. Internal to fem/.

#include "fem/seepage/newton.hpp"
#include "mesh/mesh.hpp"

namespace talus::fem {

// The line of zero pore pressure in a plane field.

/// Polylines [m] where the nodal pressure (linear in elements that hold soil) goes from at most zero to above it.
/// Open lines start at their end with the smaller x; closed ones repeat their first point.
std::vector<std::vector<std::array<double, 2>>> find_water_table(const mesh::Mesh<2>& mesh,
                                                                 const std::vector<double>& pressure);

/// Water through boundaries, roots and stores. `sums` are those of the solution, `conditions` and `input` what it was
/// solved with. The fields are empty.
template <int D>
SeepageResult<D> make_flow_result(const SeepageSystem<D>& system, const SeepageState& state, const NodalSums& sums,
                                  const std::vector<NodeCondition>& conditions, double time, const StepInput& input);

/// Heads, pressures, saturations, velocities, wet faces and water table of the solution.
template <int D>
void add_fields(const SeepageSystem<D>& system, const SeepageState& state, const StepInput& input,
                SeepageResult<D>& result);

/// Heads per unknown from heads per node, and back: nodes without soil get their elevation.
template <int D>
std::vector<double> to_unknowns(const SeepageSystem<D>& system, const std::vector<double>& node_heads);
template <int D>
std::vector<double> to_nodes(const SeepageSystem<D>& system, const std::vector<double>& heads);

}  // namespace talus::fem
