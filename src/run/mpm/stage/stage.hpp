// SPDX-License-Identifier: MIT
#pragma once
// One stage: the loop over steps with the time step, the rest criterion, the check of stability, and the retry with a
// smaller step.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "mpm/solver/critical_step.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/solver/step.hpp"
#include "results/trial.hpp"

namespace talus::run {

// Access to a body between two steps, for output.

template <int D>
struct StagePlan;

template <int D>
class Pause {
 public:
  virtual ~Pause() = default;
  /// Returns the body with time, step count, work, losses, water budgets and the last monitored step up to date.
  virtual const mpm::Body<D>& known() = 0;
  /// Returns the body with everything up to date.
  virtual const mpm::Body<D>& whole() = 0;
  /// Returns the values of a history row. A device evaluates them without a copy of the body to the host.
  virtual mpm::Observation<D> observe(const Vec<D>& gravity, const std::vector<int>& points) = 0;
  virtual mpm::CriticalStep find_critical_step(const StagePlan<D>& plan) = 0;
};

/// Access to a body in host memory.
template <int D>
class PauseHere : public Pause<D> {
 public:
  explicit PauseHere(const mpm::Body<D>& body) : body_(body) {}
  const mpm::Body<D>& known() override { return body_; }
  const mpm::Body<D>& whole() override { return body_; }
  mpm::Observation<D> observe(const Vec<D>& gravity, const std::vector<int>& points) override {
    return mpm::observe(body_, gravity, points);
  }
  mpm::CriticalStep find_critical_step(const StagePlan<D>& plan) override;

 private:
  const mpm::Body<D>& body_;
};

template <int D>
class Helpers;  // see ranks_stage.hpp

/// Definition of a stage, without the body. All of it follows from the case.
template <int D>
struct StagePlan {
  std::string name;
  std::optional<double> cohesion;  ///< of every material, instead of its own [Pa]
  double strength_factor = 1;      ///< divides the strength
  double duration = 0;             ///< [s]; the longest time if until_rest
  bool until_rest = false;
  input::StepSettings step;
  input::RestCriterion rest;
  Vec<D> gravity{};                ///< at full strength [m/s²]
  double gravity_ramp = 0;         ///< [s]
  double soil_height = 0;          ///< H of the rest criterion [m]
  double failed_displacement = 0;  ///< the stage ends when a point has moved farther [m]; 0: never
  bool equalises_mass = false;     ///< small elements do not limit the step (frozen_body.hpp)
  int threads = 1;
  Helpers<D>* helpers = nullptr;  ///< the other ranks, if only this one has the body
  ShownUnits units;               ///< units of messages
};

/// State of a stage. Together with the body it suffices to resume bitwise identically.
struct StageState {
  bool started = false;
  double start_time = 0;  ///< [s]
  std::int64_t steps = 0;
  double dt = 0;             ///< last time step [s]
  double gravity_share = 0;  ///< fraction of full gravity at the start of the stage
  double calm_since = -1;    ///< time since which the rest criterion holds [s]; -1: it does not
  double next_output = 0;    ///< simulated time of the next call of StageHooks::output [s]
  double largest_speed = 0;  ///< of any node, in the whole stage [m/s]
  double wave_speed = 0;     ///< of compression waves, at the start of the stage [m/s]
  double soft_band = 0;      ///< smallest thickness of a softening band so far, in elements; 0: no band
  double soft_size = 0;      ///< largest element size of such a band [m]
  std::vector<results::Retry> setbacks;
};

/// Restores the output to the state at which the function was made, that of the body which it receives; the plan is
/// the changed one.
template <int D>
using GoBack = std::function<void(const mpm::Body<D>&, const StageState&, const StagePlan<D>&)>;

/// Callbacks during a stage. All may be empty.
template <int D>
struct StageHooks {
  /// Called when body.time reaches state.next_output, which it must advance.
  std::function<void(Pause<D>&, StageState&)> output;
  /// Called every look_interval steps, if look_is_due is empty or returns true: checkpoints. May throw to end the run.
  std::function<void(const mpm::Body<D>&, const StageState&)> look;
  std::function<bool()> look_is_due;
  /// Called in the same way for progress; of the body only time, step count and monitor are up to date. `moved`:
  /// largest displacement of a point [m].
  std::function<void(const mpm::Body<D>&, const StageState&, double moved)> report;
  std::function<bool()> report_is_due;  ///< required with `report`
  /// Called every look_interval steps. May replace the body by another one with the same state but another partition
  /// among ranks.
  std::function<void(mpm::Body<D>&)> rebalance;
  /// Called with the last good body before an unstable run ends; returns where it was saved, for the message.
  std::function<std::string(const mpm::Body<D>&, const StageState&)> save_last_good;
  /// Called when a copy of the body is made from which an unstable run can be repeated.
  std::function<GoBack<D>()> mark;
};

/// Steps between looks at time step, progress and interruption, and between evaluations of the rest criterion.
inline constexpr int look_interval = 64;
inline constexpr int monitor_interval = 8;

/// Returns the settings of the plan for the engine, without time step and gravity.
template <int D>
mpm::StepOptions<D> make_options(const StagePlan<D>& plan);

/// Largest stable step [s] of the plan for Courant number 1, and the element that limits it.
template <int D>
mpm::CriticalStep find_critical_step(const mpm::Body<D>& body, const StagePlan<D>& plan);

template <int D>
mpm::CriticalStep PauseHere<D>::find_critical_step(const StagePlan<D>& plan) {
  return run::find_critical_step(body_, plan);
}

/// Advances the body to the end of the stage. Pore pressures are fixed if the plan requires it, and inertia is
/// equalised if the plan requires it (frozen_body.hpp). `state` is new or from a checkpoint; the strength of the body
/// must be set. An unstable stage is repeated from its last good state with the plan of calm_down(), and the retry is
/// recorded in state.setbacks. After the last retry throws Error (unstable) with place and reason.
template <int D>
results::StageEnd run_stage(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                            const StageHooks<D>& hooks = {});

/// Plan of stage `stage` of a case.
template <int D>
StagePlan<D> make_plan(const input::Case& data, const input::Stage& stage, double soil_height, int threads);

/// Gravity [m/s²] at `time` of the stage.
template <int D>
Vec<D> find_stage_gravity(const StagePlan<D>& plan, const StageState& state, double time);

/// Returns true if the last monitored step satisfies the rest criterion, regardless of the holding time.
template <int D>
bool is_calm(const mpm::Body<D>& body, const StagePlan<D>& plan);

/// Largest number of retries of an unstable stage.
inline constexpr std::size_t most_setbacks = 3;

/// Returns the plan after this number of retries: the time step is halved for each, and smoothing that may be the cause
/// is replaced. With the two-velocity formulation smoothing is switched off; otherwise the first retry uses the stable
/// form, and from the second retry on there is no smoothing.
template <int D>
StagePlan<D> calm_down(StagePlan<D> plan, std::size_t setbacks, bool wet);

/// The states from which a stage can be repeated: its start, and two copies made while it runs.
template <int D>
class GoodStates {
 public:
  GoodStates(const StagePlan<D>& plan, const StageHooks<D>& hooks) : plan_(plan), hooks_(hooks) {}

  /// Copies the body in its present state.
  void keep(const mpm::Body<D>& body, const StageState& state);
  /// The newest copy that is old enough to precede an instability.
  const mpm::Body<D>& good_body() const { return older_->body; }
  const StageState& good_state() const { return older_->state; }

  /// Restores body, state and output to the last good state, and records the `reason` in state.setbacks. Returns false
  /// if most_setbacks is reached.
  bool go_back(mpm::Body<D>& body, StageState& state, const std::string& reason);

 private:
  struct Kept {
    mpm::Body<D> body;
    StageState state;
    GoBack<D> go_back;
  };
  const StagePlan<D>& plan_;
  const StageHooks<D>& hooks_;
  std::shared_ptr<const Kept> start_, older_, newer_;  ///< may be identical
};

}  // namespace talus::run
