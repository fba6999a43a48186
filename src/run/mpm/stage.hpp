// SPDX-License-Identifier: MIT
#pragma once
// One period of time: the loop over steps, with the time step, the end at rest, and the check of stability.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "mpm/body/observe.hpp"
#include "mpm/step/critical_step.hpp"
#include "mpm/step/step.hpp"
#include "results/trial.hpp"

namespace talus::run {

// A body between two steps, for those who record it.

template <int D>
struct StagePlan;  // stage.hpp

template <int D>
class Pause {
 public:
  virtual ~Pause() = default;
  /// The body, of which time, step count, work, losses, the water's budgets and the last monitored step are up to date.
  virtual const mpm::Body<D>& known() = 0;
  /// All of it is.
  virtual const mpm::Body<D>& whole() = 0;
  /// What a row of a history tells. A device finds it without bringing the body back.
  virtual mpm::Observation<D> observe(const Vec<D>& gravity, const std::vector<int>& points) = 0;
  virtual mpm::CriticalStep find_critical_step(const StagePlan<D>& plan) = 0;
};

/// Of a body that is here.
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
class Helpers;  // ranks_stage.hpp

/// What a stage is, apart from the body. Everything here follows from the case.
template <int D>
struct StagePlan {
  std::string name;
  std::optional<double> cohesion;  ///< of every material, instead of its own [Pa]
  double strength_factor = 1;      ///< divides the strength
  double duration = 0;             ///< [s]; the longest time when until_rest
  bool until_rest = false;
  input::StepSettings step;
  input::RestCriterion rest;
  Vec<D> gravity{};                ///< at full strength [m/s²]
  double gravity_ramp = 0;         ///< [s]
  double soil_height = 0;          ///< H of the rest criterion [m]
  double failed_displacement = 0;  ///< stop when a point has moved farther [m]; 0: never
  bool equalises_mass =
      false;  ///< frozen geometry of one phase: small elements do not decide the step (equalise_mass.hpp)
  int threads = 1;
  Helpers<D>* helpers = nullptr;  ///< other ranks, where this one alone has the body
};

/// Where a stage stands. With the body, all that is needed to go on bit for bit.
struct StageState {
  bool started = false;
  double start_time = 0;  ///< [s]
  std::int64_t steps = 0;
  double dt = 0;             ///< last time step [s]
  double gravity_share = 0;  ///< of full gravity, at the start of the stage
  double calm_since = -1;    ///< time since which the rest criterion holds [s]; -1: it does not
  double next_output = 0;    ///< simulated time of the next call of StageHooks::output [s]
  double largest_speed = 0;  ///< of a node, in the whole stage [m/s]
  double wave_speed = 0;     ///< compression waves at the start of the stage [m/s]
  double soft_band = 0;      ///< thinnest band of soil that softens, so far, in elements; 0: none
  double soft_size = 0;      ///< largest elements of such a band [m]
  std::vector<results::Retry> setbacks;
};

/// Puts what is recorded back to where it was when the function was made, as the body now is. The plan: the changed
/// one.
template <int D>
using GoBack = std::function<void(const mpm::Body<D>&, const StageState&, const StagePlan<D>&)>;

/// Callbacks while a stage runs. All may be empty.
template <int D>
struct StageHooks {
  /// Called when body.time reaches state.next_output, which it must advance.
  std::function<void(Pause<D>&, StageState&)> output;
  /// Called every look_interval steps where look_is_due, or where that is empty: checkpoints. May throw to end the run.
  std::function<void(const mpm::Body<D>&, const StageState&)> look;
  std::function<bool()> look_is_due;
  /// The same for progress, which needs less: of the body only time, step count and monitor are up to date. `moved`:
  /// the largest displacement of a point [m].
  std::function<void(const mpm::Body<D>&, const StageState&, double moved)> report;
  std::function<bool()> report_is_due;  ///< where there is `tell`
  /// Called every look_interval steps. May put another body in place, which goes on with the same numbers: with other
  /// parts of the soil on this rank.
  std::function<void(mpm::Body<D>&)> rebalance;
  /// Called with the last good body before an unstable run is given up; returns where it was saved, for the message.
  std::function<std::string(const mpm::Body<D>&, const StageState&)> save_last_good;
  /// Called when the body is kept as one to which an unstable run may return.
  std::function<GoBack<D>()> mark;
};

/// Steps between looks at time step, progress and interruption, and between evaluations of the rest criterion.
inline constexpr int look_interval = 64;
inline constexpr int monitor_interval = 8;

/// The settings of the plan for the engine, but for time step and gravity.
template <int D>
mpm::StepOptions<D> make_options(const StagePlan<D>& plan);

/// Largest stable step [s] for Courant number 1 as the plan calculates, and the element that decides it.
template <int D>
mpm::CriticalStep find_critical_step(const mpm::Body<D>& body, const StagePlan<D>& plan);

template <int D>
mpm::CriticalStep PauseHere<D>::find_critical_step(const StagePlan<D>& plan) {
  return run::find_critical_step(body_, plan);
}

/// Advances the body to the end of the stage. Pore pressures that the plan holds are held (drained.hpp); inertia is
/// evened where the plan says so. `state` fresh or from a checkpoint; body strength must be set. A stage that becomes
/// unstable goes back to its last good state and on with the plan of calm_down() (setback.hpp); state.setbacks tells of
/// it. After the last of them, Error (unstable) with a sentence that says where and why.
template <int D>
results::StageEnd run_stage(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                            const StageHooks<D>& hooks = {});

/// Plan of the stage `index` of a case.
template <int D>
StagePlan<D> make_plan(const input::Case& data, const input::Stage& stage, double soil_height, int threads);

/// Gravity [m/s²] that acts at `time` of the stage.
template <int D>
Vec<D> find_stage_gravity(const StagePlan<D>& plan, const StageState& state, double time);

/// Rest as the last monitored step shows it, without the holding time.
template <int D>
bool is_calm(const mpm::Body<D>& body, const StagePlan<D>& plan);

// How a stage that became unstable goes back to its last good state, and on with a smaller step.

/// An unstable stage is calculated again at most this often.
inline constexpr std::size_t most_setbacks = 3;

/// The plan after so many setbacks: half the time step for each, and without smoothing that may be the cause. With
/// flowing pore water that is any smoothing; without it plain strain smoothing, and from the second setback on any.
template <int D>
StagePlan<D> calm_down(StagePlan<D> plan, std::size_t setbacks, bool wet);

/// The states of a stage to which it may go back: its start, and two more that are kept while it runs.
template <int D>
class GoodStates {
 public:
  GoodStates(const StagePlan<D>& plan, const StageHooks<D>& hooks) : plan_(plan), hooks_(hooks) {}

  /// Keeps a copy of the body as it is now.
  void keep(const mpm::Body<D>& body, const StageState& state);
  /// The newest one that is old enough to be called good.
  const mpm::Body<D>& good_body() const { return older_->body; }
  const StageState& good_state() const { return older_->state; }

  /// Puts body, state and what was recorded back to the last good state, and tells of it in state.setbacks: `reason`.
  /// False where the stage was put back often enough, or would be without end.
  bool go_back(mpm::Body<D>& body, StageState& state, const std::string& reason);

 private:
  struct Kept {
    mpm::Body<D> body;
    StageState state;
    GoBack<D> go_back;
  };
  const StagePlan<D>& plan_;
  const StageHooks<D>& hooks_;
  std::shared_ptr<const Kept> start_, older_, newer_;  ///< may be one and the same
};

}  // namespace talus::run
