// SPDX-License-Identifier: MIT
#pragma once
// Steps that equilibrium and strength reduction have in common. Internal to fem/.

#include "fem/solid/newton.hpp"

namespace talus::fem {

/// Returns the laws of all regions at a factor, with a placeholder for regions without elements.
template <int D>
std::vector<material::Law> make_laws(const SolidModel<D>& model, double factor);

/// Applies the loads of the model from `start` in load steps.
template <int D>
SolidResult<D> apply_loads(const SolidSystem<D>& system, SolidNewton<D>& newton, const SolidAssembly<D>& assembly,
                           const SolidOptions& options, const SolidState<D>& start);

}  // namespace talus::fem
