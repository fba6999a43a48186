// SPDX-License-Identifier: MIT
#pragma once
// The results of a body of material points: its mesh, and the balances of energy, momentum and mass.

#include "input/case/case.hpp"
#include "mpm/body/body.hpp"
#include "results/run.hpp"
#include "results/water.hpp"

namespace talus::run {

/// Mesh and points.
template <int D>
results::Mesh make_mesh_result(const mpm::Body<D>& body);

/// Energy, momentum and mass: what came in, what is there, what was lost.
template <int D>
results::Budgets make_budgets_result(const mpm::Body<D>& body, const Vec<D>& gravity, const mpm::Work& before);

/// Wall seconds by part of the step.
results::StepSeconds make_seconds_result(const mpm::Timing& timing);

// The results of the pore water of a run.

/// Water at the start and now, and what passed each condition [kg], [Pa]. `initial` is its mass at the start. The
/// error of the budget is given as a share of the water in the model.
template <int D>
results::WaterBudget make_water_result(const input::Case& data, const mpm::Body<D>& body, double initial);

}  // namespace talus::run
