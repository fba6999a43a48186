// SPDX-License-Identifier: MIT
#pragma once
// The displacement–SRF curve on moving geometry, and the runout of chosen trials.

#include <map>

#include <optional>

#include "run/mpm/record/runout.hpp"
#include "run/mpm/reduction/criteria.hpp"
#include "run/mpm/reduction/leg.hpp"

namespace talus::run {

struct CurveResult {
  std::vector<results::Trial> trials;         ///< by factor, each at the end of the window
  std::vector<results::RunoutTrial> runouts;  ///< likewise
  std::vector<CurvePoint> points() const;
};

/// Runs all trials of the curve, refines it where it bends, and goes on to rest for the factors of curve.runout.
/// `state` is the body after the stages. Factors do not depend on `threads`.
template <int D>
CurveResult compute_curve(const mpm::Body<D>& state, const TrialContext& context, double slope_height, int threads);

}  // namespace talus::run
