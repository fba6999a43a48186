// SPDX-License-Identifier: MIT
#pragma once
// Steps that equilibrium and strength reduction share. Internal to fem/.

#include "fem/solid/newton.hpp"

namespace talus::fem {

/// The laws of all regions at a factor; regions that no element has get a placeholder.
template <int D>
std::vector<material::Law> make_laws(const SolidModel<D>& model, double factor);

/// From `start` to the loads of the model, in load steps.
template <int D>
SolidResult<D> apply_loads(const SolidSystem<D>& system, SolidNewton<D>& newton, const SolidAssembly<D>& assembly,
                           const SolidOptions& options, const SolidState<D>& start);

}  // namespace talus::fem
