// SPDX-License-Identifier: MIT
#pragma once
// The results of the pore water of a run.

#include "input/case/case.hpp"
#include "mpm/body/body.hpp"
#include "results/water.hpp"

namespace talus::run {

/// Water at the start and now, and what passed each condition [kg], [Pa]. `initial` is its mass at the start. The
/// error of the budget is given as a share of the water in the model.
template <int D>
results::WaterBudget make_water_result(const input::Case& data, const mpm::Body<D>& body, double initial);

}  // namespace talus::run
