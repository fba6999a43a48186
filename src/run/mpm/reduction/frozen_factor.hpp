// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety of Talus: at frozen geometry a trial either comes to rest or runs away, and bisection finds the
// factor between. Evidence and definitions: docs/theory/factor-of-safety.md.

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "run/mpm/reduction/trial.hpp"

namespace talus::run {

/// A warning where trials that neither rested nor ran away leave the factor of a mesh open by 2 % or more; else empty.
std::string describe_undecided(const results::MeshFactor& mesh, const input::FrozenFactor& settings);

/// The plan of a mesh of the factor: every element size of `plan` halved `halvings` times (−1: doubled), re-entrant
/// corners refined.
mesh::Plan plan_frozen_mesh(mesh::Plan plan, const input::FrozenFactor& settings, int halvings);

/// Trials that were calculated before, by factor.
using KnownTrials = std::map<double, results::Trial>;

/// The trials with some factors, in their order.
using RunTrials = std::function<std::vector<results::Trial>(const std::vector<double>& factors)>;

/// Bisects between rest and run-away. The factors that are tried do not depend on how many trials run at the same time:
/// every round tries two that cut the bracket into three.
results::MeshFactor search_frozen_factor(const input::FrozenFactor& settings, const RunTrials& run_trials);

/// The trial at frozen geometry. `slope_height` is H of the criteria [m].
template <int D>
StagePlan<D> make_frozen_plan(const input::Case& data, const input::FrozenFactor& settings, double slope_height,
                              int threads);

/// The factor of the body `state` (at rest under real strength, geometry frozen all along), with nothing kept on disk.
template <int D>
results::MeshFactor find_frozen_factor(const mpm::Body<D>& state, const input::Case& data,
                                       const input::FrozenFactor& settings, double slope_height, int threads);

/// Factors of the two meshes farther apart than this make the extrapolation a guess [-].
inline constexpr double far_apart = 0.1;

/// The factor of one mesh, or where the line through the meshes is at elements of no size. Its interval: half the width
/// of the final brackets as the extrapolation passes them on, and what the mesh does. `meshes`: coarse to fine, the
/// last two and `coarser`, of twice the size, or the last three make the line. `other`: the coarsest by another mesher.
/// Both where they were calculated. Angles of dilatancy are left to the caller. `dimension`: 2, or 3 for tetrahedra.
results::FrozenFactor join_meshes(std::vector<results::MeshFactor> meshes,
                                  std::optional<results::MeshFactor> coarser = {},
                                  std::optional<results::MeshFactor> other = {}, int dimension = 2);

}  // namespace talus::run
