// SPDX-License-Identifier: MIT
#include "run/mpm/reduction/trial.hpp"

#include <algorithm>

#include "mpm/solver/observe.hpp"
#include "run/mpm/start/prepare.hpp"

namespace talus::run {

template <int D>
mpm::Body<D> start_trial(const mpm::Body<D>& state, const input::Case& data, double factor) {
  mpm::Body<D> body = state;
  set_strength(body, data, {}, factor);
  mpm::reset_displacements(body);
  body.timing = {};
  return body;
}

template <int D>
results::Trial run_trial(mpm::Body<D>& body, double factor, const StagePlan<D>& plan, StageState& state,
                         const StageHooks<D>& hooks) {
  results::Trial r;
  r.factor = factor;
  r.end = run_stage(body, plan, state, hooks);
  r.displacement = mpm::find_largest_displacement(body).value;
  r.time = body.time - state.start_time;
  r.steps = state.steps;
  r.force_ratio = find_force_ratio(body.monitor);
  r.speed = body.monitor.speed;
  r.largest_speed = state.largest_speed;
  if (!state.setbacks.empty()) r.setbacks = state.setbacks;
  return r;
}

template mpm::Body<2> start_trial<2>(const mpm::Body<2>&, const input::Case&, double);
template mpm::Body<3> start_trial<3>(const mpm::Body<3>&, const input::Case&, double);
template results::Trial run_trial<2>(mpm::Body<2>&, double, const StagePlan<2>&, StageState&, const StageHooks<2>&);
template results::Trial run_trial<3>(mpm::Body<3>&, double, const StagePlan<3>&, StageState&, const StageHooks<3>&);

}  // namespace talus::run
