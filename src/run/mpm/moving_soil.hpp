// SPDX-License-Identifier: MIT
#pragma once
// What moves at the end of a stage that should have come to rest, and what is said of it and of setbacks.

#include <string>

#include "input/case/case.hpp"
#include "mpm/body/body.hpp"
#include "results/trial.hpp"

namespace talus::run {

/// The material of the point nearest to `x` [m]; "unknown" where no point is left.
template <int D>
std::string find_nearest_material(const mpm::Body<D>& body, const std::type_identity_t<Vec<D>>& x);

/// What moves, from the last step that was monitored.
template <int D>
results::MovingSoil find_moving_soil(const mpm::Body<D>& body);

/// "stage 'slide' did not come to rest within 40 s: …", with what to do.
std::string describe_restless(const input::Stage& stage, const results::Stage& report);

/// "stage 'slide' became unstable at t = 3 s: …", with how it was calculated instead and what to do. `what`: "stage
/// 'slide'".
std::string describe_setback(const std::string& what, const results::Retry& setback);

}  // namespace talus::run
