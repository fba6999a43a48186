#pragma once
// One trial of the strength reduction: from a saved state, with reduced strength, for a window of time.

#include "run/mpm/stage.hpp"

namespace talus::run {

struct TrialResult {
  double factor = 0;  ///< strength reduction factor
  StageEnd end = StageEnd::time;
  double displacement = 0;  ///< largest of a point at the end, from the trial's start [m]
  double time = 0;          ///< simulated [s]
  std::int64_t steps = 0;
  double force_ratio = 0;    ///< ‖F_ext+G-F_int‖/‖F_ext+G‖ at the end
  double speed = 0;          ///< largest nodal speed at the end [m/s]
  double largest_speed = 0;  ///< in the whole trial [m/s]
};

/// Prepares a body for a trial: reduced strength (3.14-3.15), displacements from zero (time and work go on).
template <int D>
mpm::Body<D> start_trial(const mpm::Body<D>& state, const input::Case& data, double factor);

/// Runs the stage `plan` on a body from start_trial and tells how it went. The body is left at the end of the trial.
template <int D>
TrialResult run_trial(mpm::Body<D>& body, double factor, const StagePlan<D>& plan, StageState& state,
                      const StageHooks<D>& hooks = {});

/// How many trials of a body of this size run side by side on `threads` threads; the rest of the threads work inside
/// the trials. Small bodies gain nothing from threads inside a step.
int count_parallel_trials(int points, int threads);

}  // namespace talus::run
