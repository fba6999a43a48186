// SPDX-License-Identifier: MIT
#pragma once
// The results of a body of material points: its mesh, and the balances of energy, momentum and mass.

#include "mpm/body/body.hpp"
#include "results/run.hpp"

namespace talus::run {

/// Mesh and points.
template <int D>
results::Mesh make_mesh_result(const mpm::Body<D>& body);

/// Energy, momentum and mass: what came in, what is there, what was lost.
template <int D>
results::Budgets make_budgets_result(const mpm::Body<D>& body, const Vec<D>& gravity, const mpm::Work& before);

/// Wall seconds by part of the step.
results::StepSeconds make_seconds_result(const mpm::Timing& timing);

}  // namespace talus::run
