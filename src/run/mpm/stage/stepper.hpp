// SPDX-License-Identifier: MIT
#pragma once
// Steps of a stage on the processor or on the device of the run, and the choice of that device.

#include <memory>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "mpm/solver/observe.hpp"
#include "run/common/run_folder.hpp"
#include "run/mpm/stage/hooks.hpp"

namespace talus::mpm {
template <int D>
class DeviceStepper;
}

namespace talus::run {

/// Advances a body. Between steps the body is up to date only after copy_back(); time, step count, work, losses and
/// the monitored values of the last step always are.
template <int D>
class Stepper : public Pause<D> {
 public:
  Stepper(mpm::Body<D>& body, const StagePlan<D>& plan);
  ~Stepper() override;

  void step(const mpm::StepOptions<D>& options);
  void filter_null_modes(const mpm::StepOptions<D>& options);
  mpm::CriticalStep find_critical_step(const StagePlan<D>& plan, const mpm::StepOptions<D>& options);
  double find_largest_displacement();
  const mpm::Body<D>& known() override { return body_; }
  const mpm::Body<D>& whole() override { return copy_back(); }
  mpm::Observation<D> observe(const Vec<D>& gravity, const std::vector<int>& points) override;
  mpm::CriticalStep find_critical_step(const StagePlan<D>& plan) override {
    return find_critical_step(plan, make_options(plan));
  }
  mpm::Body<D>& copy_back();
  /// Must be called after the body was changed on the host, or replaced by another one.
  void note_change();

 private:
  mpm::Body<D>& body_;
  std::unique_ptr<mpm::DeviceStepper<D>> device_;  ///< null: the steps run on the processor
};

/// Parses the argument of --device. Throws Error (wrong_input) for an unknown one.
DeviceKind find_device_kind(const std::string& word);

/// During its lifetime MPM steps run on the device of the options. Throws Error (wrong_input) if there is no such
/// device, or it cannot run the case.
class ChosenDevice {
 public:
  ChosenDevice(const input::Case& data, const RunOptions& options);
  ~ChosenDevice();
  ChosenDevice(const ChosenDevice&) = delete;
  ChosenDevice& operator=(const ChosenDevice&) = delete;
};

/// Name of the device in use; empty if there is none.
std::string describe_device();

/// Lists the stages that the device in use does not support, because they use the two-velocity formulation; they run
/// on the processor.
std::vector<std::string> list_left_to_processor(const input::Case& data);

}  // namespace talus::run
