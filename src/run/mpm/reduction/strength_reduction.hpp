// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety of a case by every criterion that it asks for.

#include <map>
#include <optional>
#include <vector>

#include "results/run.hpp"
#include "run/mpm/record/runout.hpp"
#include "run/mpm/reduction/criteria.hpp"
#include "run/mpm/reduction/leg.hpp"

namespace talus::run {

// The displacement–SRF curve on moving geometry, and the runout of chosen trials.

struct CurveResult {
  std::vector<results::Trial> trials;         ///< by factor, each at the end of the window
  std::vector<results::RunoutTrial> runouts;  ///< likewise
  std::vector<CurvePoint> points() const;
};

/// Runs all trials of the curve, refines it where it bends, and goes on to rest for the factors of curve.runout.
/// `state` is the body after the stages. Factors do not depend on `threads`.
template <int D>
CurveResult compute_curve(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads);

/// Runs what [strength_reduction] asks for and puts curve, criteria, runouts and the frozen factor into `run`.
/// `state` is the body after the stages; it is not needed, and may be empty, when the curve is not asked for.
template <int D>
void reduce_strength(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads,
                     results::RunResult& run, std::vector<std::string>& warnings);

}  // namespace talus::run
