// SPDX-License-Identifier: MIT
#pragma once
// What takes the body of a stage through its steps: this processor, or the device of the run.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "input/case/case.hpp"
#include "mpm/body/observe.hpp"
#include "mpm/device/device_stepper.hpp"
#include "run/mpm/stage.hpp"
#include "run/run_folder.hpp"

namespace talus::run {

/// Between steps the body is up to date after bring_back() only; time, step count, work, losses and what the last step
/// was monitored for always are.
template <int D>
class Stepper : public Pause<D> {
 public:
  Stepper(mpm::Body<D>& body, const StagePlan<D>& plan) : body_(body) {
    if (body.water.is_wet() && plan.step.water == input::WaterMotion::flows) return;  // devices know one velocity
    if (auto device = mpm::make_device<D>()) device_.emplace(std::move(device));
  }

  void step(const mpm::StepOptions<D>& options) { device_ ? device_->step(body_, options) : mpm::step(body_, options); }
  void fade_unseen(const mpm::StepOptions<D>& options) {
    device_ ? device_->fade_unseen(body_) : mpm::fade_unseen(body_, options);
  }
  mpm::CriticalStep find_critical_step(const StagePlan<D>& plan, const mpm::StepOptions<D>& options) {
    return device_ ? device_->find_critical_step(body_, options) : run::find_critical_step(body_, plan);
  }
  double find_largest_displacement() {
    return device_ ? device_->find_largest_displacement(body_) : mpm::find_largest_displacement(body_).value;
  }
  const mpm::Body<D>& known() override { return body_; }
  const mpm::Body<D>& whole() override { return bring_back(); }
  mpm::Observation<D> observe(const Vec<D>& gravity, const std::vector<int>& points) override {
    return device_ ? device_->observe(body_, gravity, points) : mpm::observe(body_, gravity, points);
  }
  mpm::CriticalStep find_critical_step(const StagePlan<D>& plan) override {
    return find_critical_step(plan, make_options(plan));
  }
  mpm::Body<D>& bring_back() {
    if (device_) device_->bring_back(body_);
    return body_;
  }
  /// The body was changed here, or another is in its place.
  void note_change() {
    if (device_) device_->note_change();
  }
  /// The end of the stage, with the body as it is then.
  results::StageEnd end(results::StageEnd how) {
    bring_back();
    return how;
  }

 private:
  mpm::Body<D>& body_;
  std::optional<mpm::DeviceStepper<D>> device_;
};

// The device of a run.

/// Of the word of --device. Throws Error (wrong_input) where it is another one.
DeviceKind find_device_kind(const std::string& word);

/// While it lives, bodies of points are taken through their steps by the device that the options name. Throws Error
/// (wrong_input) where there is no such device, or it cannot calculate the case.
class ChosenDevice {
 public:
  ChosenDevice(const input::Case& data, const RunOptions& options);
  ~ChosenDevice();
  ChosenDevice(const ChosenDevice&) = delete;
  ChosenDevice& operator=(const ChosenDevice&) = delete;
};

/// The name of the device in use, empty where none is.
std::string describe_device();

/// The stages that a device which is used does not calculate, because water has a velocity of its own there.
std::vector<std::string> list_left_to_processor(const input::Case& data);

}  // namespace talus::run
