// SPDX-License-Identifier: MIT
#pragma once
// A body between two steps, for those who record it.

#include <vector>

#include "mpm/body/observe.hpp"
#include "mpm/step/critical_step.hpp"

namespace talus::run {

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

}  // namespace talus::run
