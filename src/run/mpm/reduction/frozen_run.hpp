// SPDX-License-Identifier: MIT
#pragma once
// The frozen-geometry factor of a case: its meshes, the stages and trials on each, and what is kept of them on disk.

#include <string>
#include <vector>

#include "run/mpm/reduction/leg.hpp"

namespace talus::run {

/// The slip line of the smallest factor that failed, in the folder of each mesh: {"srf", "points"}; plane cases only.
inline constexpr const char* slip_line_file = "slip_line.json";

/// The factor on meshes of the case's size and of half of it, by the mesher of [strength_reduction.frozen]; a ready
/// mesh
/// (`base`) is used as it is. Stages and trials keep checkpoints under folder/frozen and are resumed from them;
/// finished trials are not calculated again. Adds sentences for the user to `warnings`.
template <int D>
results::FrozenFactor compute_frozen_factor(const mesh::Mesh<D>& base, const TrialContext& context, int threads,
                                            std::vector<std::string>& warnings);

}  // namespace talus::run
