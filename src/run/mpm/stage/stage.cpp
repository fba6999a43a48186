// SPDX-License-Identifier: MIT
#include "run/mpm/stage/stage.hpp"

#include <algorithm>

#include "material/every_law.hpp"
#include "mpm/state/partition.hpp"
#include "run/mpm/stage/recovery.hpp"

namespace talus::run {

namespace {

/// Steps between two evaluations of the critical step. The interval is short for soil that stiffens as its weight is
/// applied, whose critical step would otherwise fall below the step in use.
template <int D>
int find_step_interval(const mpm::Body<D>& body) {
  constexpr int changing = 4;
  static_assert(look_interval % changing == 0, "a checkpoint, which is made at a look, has the step that follows it");
  const bool follows = std::any_of(body.laws.begin(), body.laws.end(),
                                   [](const material::Law& law) { return material::traits_of(law).changes_stiffness; });
  return follows ? changing : look_interval;
}

/// Reports progress where it is due. Returns true if a point has moved farther than the plan allows.
template <int D>
bool has_failed(SteppedBody<D>& stepped, Stepper<D>& stepper, const StageState& state) {
  const double limit = stepped.plan().failed_displacement;
  const bool reports = stepped.is_report_due();
  if (!reports && limit <= 0) return false;
  const double moved = find_largest(stepped.body(), stepper.find_largest_displacement());
  if (reports) stepped.report(state, moved);
  return limit > 0 && moved > limit;
}

template <int D>
void start(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state) {
  if (state.started) return;
  state.started = true;
  state.start_time = body.time;
  state.next_output = body.time;
  mpm::gather_nodal_sums(body, make_options(plan));
}

/// Steps the body until the stage ends.
template <int D>
results::StageEnd step_to_end(SteppedBody<D>& stepped, Stepper<D>& stepper, StageState& state) {
  const mpm::Body<D>& body = stepped.body();
  Recovery<D> recovery(stepped, stepper, state);
  const StagePlan<D>& plan = recovery.plan();
  const double end = state.start_time + plan.duration;
  const int step_interval = find_step_interval(body);
  for (;;) {
    mpm::StepOptions<D> options = make_options(plan);
    if (state.steps % step_interval == 0) {
      const mpm::CriticalStep critical = stepper.find_critical_step(plan, options);
      if (critical.element < 0) return results::StageEnd::time;  // no material point is left on the grid
      state.dt = plan.step.courant * critical.dt;
      if (recovery.retry_below_smallest_step(critical)) continue;
    }
    if (state.steps % look_interval == 0) {
      stepped.rebalance();
      recovery.keep_at_look();
      stepped.look(stepper, state);
      if (has_failed(stepped, stepper, state)) return results::StageEnd::failed;
    }
    stepped.write_output(stepper, state);
    const double left = end - body.time;
    if (left <= 1e-12 * plan.duration) return results::StageEnd::time;
    options.dt = std::min(state.dt, left);
    options.gravity = find_stage_gravity(plan, state, body.time);
    options.monitor = state.steps % monitor_interval == 0;
    const std::size_t lost_before = body.lost.size();
    stepper.step(options);
    ++state.steps;
    // Null modes are filtered at the end of a step and before the look, so that a checkpoint contains the result. A
    // wave crosses about as many elements as there are steps between two looks.
    if (plan.step.filter_null_modes && options.moving && state.steps % look_interval == 0)
      stepper.filter_null_modes(options);
    if (recovery.retry_above_wave_speed(options.monitor, lost_before)) continue;
    if (!options.monitor) continue;
    state.largest_speed = std::max(state.largest_speed, body.monitor.speed);
    if (plan.until_rest && has_rested(body, plan, state)) return results::StageEnd::rest;
  }
}

}  // namespace

template <int D>
results::StageEnd advance_stage(SteppedBody<D>& stepped, StageState& state) {
  start(stepped.body(), stepped.plan(), state);
  Stepper<D> stepper(stepped.body(), stepped.plan());
  const results::StageEnd end = step_to_end(stepped, stepper, state);
  stepper.copy_back();
  stepped.finish();
  return end;
}

template <int D>
results::StageEnd run_stage(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                            const StageHooks<D>& hooks) {
  SteppedBody<D> stepped(body, plan, state, hooks);
  return advance_stage(stepped, state);
}

#define TALUS_INSTANTIATE(D)                                                 \
  template results::StageEnd advance_stage<D>(SteppedBody<D>&, StageState&); \
  template results::StageEnd run_stage<D>(mpm::Body<D>&, const StagePlan<D>&, StageState&, const StageHooks<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
