// SPDX-License-Identifier: MIT
#pragma once
// The frozen-geometry factor of a case: its meshes, the stages and trials on each, and their files.

#include <string>
#include <vector>

#include "run/mpm/reduction/leg.hpp"

namespace talus::run {

/// Computes the factor on meshes of the size of the case and of half of it, with the mesher of
/// [strength_reduction.frozen]; an existing mesh (`base`) is used as it is. Stages and trials are resumed from
/// checkpoints under folder/frozen; finished trials are not repeated. Adds warnings for the user to `warnings`.
template <int D>
results::FrozenFactor compute_frozen_factor(const mesh::Mesh<D>& base, const TrialContext& context, int threads,
                                            std::vector<std::string>& warnings);

}  // namespace talus::run
