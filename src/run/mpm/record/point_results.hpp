// SPDX-License-Identifier: MIT
#pragma once
// Results of an MPM body: mesh, budgets of energy, momentum and mass, wall-clock time by phase, and the water budget.

#include "input/case/case.hpp"
#include "mpm/state/body.hpp"
#include "results/run.hpp"
#include "results/water.hpp"

namespace talus::run {

/// Summarises the mesh and the material points.
template <int D>
results::Mesh make_mesh_result(const mpm::Body<D>& body);

/// Returns the budgets of energy, momentum and mass: input, present content and losses. `before` is the work done
/// before the run, which is subtracted.
template <int D>
results::Budgets make_budgets_result(const mpm::Body<D>& body, const Vec<D>& gravity, const mpm::Work& before);

/// Wall-clock seconds by phase of the step.
results::StepSeconds make_seconds_result(const mpm::Timing& timing);

/// Returns the water budget [kg]: contents at the start and now, and the flow through each condition, with pressures
/// in Pa. `initial` is the mass of water at the start. The error of the budget is a fraction of the water in the
/// model.
template <int D>
results::WaterBudget make_water_result(const input::Case& data, const mpm::Body<D>& body, double initial);

}  // namespace talus::run
