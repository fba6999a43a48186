// SPDX-License-Identifier: MIT
#pragma once
// Factor of safety at frozen geometry: a trial either comes to rest or fails, and bisection finds the factor in
// between. Definitions and evidence: docs/theory/factor-of-safety.md.

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "run/mpm/reduction/trial.hpp"

namespace talus::run {

/// Returns a warning if undecided trials leave the factor of a mesh uncertain by 2 % or more; empty otherwise.
std::string describe_undecided(const results::MeshFactor& mesh, const input::FrozenFactor& settings,
                               const ShownUnit& length);

/// Returns the plan of a mesh for the factor: every element size of `plan` halved `halvings` times (−1: doubled),
/// re-entrant corners refined.
mesh::Plan plan_frozen_mesh(mesh::Plan plan, const input::FrozenFactor& settings, int halvings);

/// Trials calculated before, by factor.
using KnownTrials = std::map<double, results::Trial>;

/// Runs the trials with some factors and returns them in the same order.
using RunTrials = std::function<std::vector<results::Trial>(const std::vector<double>& factors)>;

/// Searches the factor between rest and failure. The factors tried do not depend on the number of concurrent trials:
/// every round tries two, which divide the bracket into three.
results::MeshFactor search_frozen_factor(const input::FrozenFactor& settings, const RunTrials& run_trials);

/// Returns the plan of a trial at frozen geometry. `slope_height` is H of the criteria [m].
template <int D>
StagePlan<D> make_frozen_plan(const input::Case& data, const input::FrozenFactor& settings, double slope_height,
                              int threads);

/// Computes the factor of the body `state` (at rest under real strength, geometry frozen throughout) without any
/// files.
template <int D>
results::MeshFactor find_frozen_factor(const mpm::Body<D>& state, const input::Case& data,
                                       const input::FrozenFactor& settings, double slope_height, int threads);

/// A larger relative difference between the factors of two meshes makes the extrapolation unreliable [-].
inline constexpr double far_apart = 0.1;

/// Returns the factor of one mesh, or the extrapolation of several to element size zero. The interval has half the
/// width of the final brackets, weighted by the extrapolation, plus the mesh effect. `meshes`: from coarse to fine;
/// the extrapolation uses the last two and `coarser`, of twice the size, or the last three. `other`: the coarsest mesh
/// by another mesher. Both are optional. The caller sets the angles of dilatancy. `dimension`: 2, or 3 for tetrahedra.
results::FrozenFactor join_meshes(std::vector<results::MeshFactor> meshes,
                                  std::optional<results::MeshFactor> coarser = {},
                                  std::optional<results::MeshFactor> other = {}, int dimension = 2);

}  // namespace talus::run
