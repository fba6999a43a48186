// SPDX-License-Identifier: MIT
#pragma once
// Callbacks of a stage for output, and their access to the body between two steps.

#include <functional>
#include <string>
#include <vector>

#include "mpm/solver/observe.hpp"
#include "run/mpm/stage/auxiliary_body.hpp"

namespace talus::run {

/// Access to a body between two steps, for output.
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
  mpm::CriticalStep find_critical_step(const StagePlan<D>& plan) override {
    return run::find_critical_step(body_, plan);
  }

 private:
  const mpm::Body<D>& body_;
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
  /// Called every look_interval steps. May replace the body that is stepped by another one with the same state but
  /// another partition among ranks.
  std::function<void(mpm::Body<D>&)> rebalance;
  /// Called with the last good body before an unstable run ends; returns where it was saved, for the message.
  std::function<std::string(const mpm::Body<D>&, const StageState&)> save_last_good;
  /// Called when a copy of the body is made from which an unstable run can be repeated.
  std::function<GoBack<D>()> mark;
};

}  // namespace talus::run
