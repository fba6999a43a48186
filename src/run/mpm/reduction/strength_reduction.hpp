// SPDX-License-Identifier: MIT
#pragma once
// Strength reduction of a case by MPM: the displacement–SRF curve on moving geometry, the runout of chosen trials, and
// the factor of safety by every requested criterion.

#include <map>
#include <optional>
#include <vector>

#include "results/run.hpp"
#include "run/mpm/record/runout.hpp"
#include "run/mpm/reduction/criteria.hpp"
#include "run/mpm/reduction/leg.hpp"

namespace talus::run {

struct CurveResult {
  std::vector<results::Trial> trials;         ///< by factor, each at the end of the window
  std::vector<results::RunoutTrial> runouts;  ///< by factor
  std::vector<CurvePoint> points() const;
};

/// Runs all trials of the curve, refines it where it bends, and continues to rest for the factors of curve.runout.
/// `state` is the body after the stages. Factors do not depend on `threads`.
template <int D>
CurveResult compute_curve(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads);

/// Runs the analyses of [strength_reduction] and writes curve, criteria, runouts and the frozen factor to `run`.
/// `state` is the body after the stages; it may be empty if no curve is requested.
template <int D>
void reduce_strength(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads,
                     results::RunResult& run, std::vector<std::string>& warnings);

}  // namespace talus::run
