// SPDX-License-Identifier: MIT
#include "run/mpm/stage/stepper.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/ranks.hpp"
#include "input/case/support.hpp"
#include "mpm/solver/device_stepper.hpp"

namespace talus::run {

template <int D>
Stepper<D>::Stepper(mpm::Body<D>& body, const StagePlan<D>& plan) : body_(body) {
  if (body.water.is_wet() && plan.step.water == input::WaterMotion::flows)
    return;  // devices do not support the two-velocity formulation
  if (auto device = mpm::make_device<D>()) device_ = std::make_unique<mpm::DeviceStepper<D>>(std::move(device));
}
template <int D>
Stepper<D>::~Stepper() = default;

template <int D>
void Stepper<D>::step(const mpm::StepOptions<D>& options) {
  device_ ? device_->step(body_, options) : mpm::step(body_, options);
}
template <int D>
void Stepper<D>::filter_null_modes(const mpm::StepOptions<D>& options) {
  device_ ? device_->filter_null_modes(body_) : mpm::filter_null_modes(body_, options);
}
template <int D>
mpm::CriticalStep Stepper<D>::find_critical_step(const StagePlan<D>& plan, const mpm::StepOptions<D>& options) {
  return device_ ? device_->find_critical_step(body_, options) : run::find_critical_step(body_, plan);
}
template <int D>
double Stepper<D>::find_largest_displacement() {
  return device_ ? device_->find_largest_displacement(body_) : mpm::find_largest_displacement(body_).value;
}
template <int D>
mpm::Observation<D> Stepper<D>::observe(const Vec<D>& gravity, const std::vector<int>& points) {
  return device_ ? device_->observe(body_, gravity, points) : mpm::observe(body_, gravity, points);
}
template <int D>
mpm::Body<D>& Stepper<D>::copy_back() {
  if (device_) device_->copy_back(body_);
  return body_;
}
template <int D>
void Stepper<D>::note_change() {
  if (device_) device_->note_change();
}
template class Stepper<2>;
template class Stepper<3>;

DeviceKind find_device_kind(const std::string& word) {
  if (word == "gpu") return DeviceKind::gpu;
  if (word == "emulated") return DeviceKind::emulated;
  if (word == "cpu") return DeviceKind::cpu;
  throw Error(ExitCode::wrong_input,
              "--device " + word + ": expected cpu, gpu, or emulated (the kernels of a GPU on the processor)");
}

ChosenDevice::ChosenDevice(const input::Case& data, const RunOptions& options) {
  const bool has_bars = !data.supports.empty() && input::uses(data, Method::mpm);
  if (has_bars && get_ranks().size() > 1)
    throw Error(ExitCode::wrong_input, "MPM takes supports on one process only; start the program without mpiexec");
  if (options.device == DeviceKind::cpu) return;
  if (has_bars)
    throw Error(ExitCode::wrong_input, "--device: MPM takes supports on the processor only; leave --device out");
  if (get_ranks().size() > 1)
    throw Error(ExitCode::wrong_input, "--device: a device calculates alone; start the program without mpiexec");
  for (const auto& [name, material] : data.materials)
    if (material.traits().is_opaque)
      throw Error(ExitCode::wrong_input, "--device: material '" + name + "' (" + material.traits().title +
                                             ") runs on the processor only; leave --device out");
  options.device == DeviceKind::gpu ? mpm::use_gpu() : mpm::use_emulated_device({.threads = options.threads});
}

ChosenDevice::~ChosenDevice() {
  mpm::use_no_device();
}

std::string describe_device() {
  return mpm::get_device_name();
}

std::vector<std::string> list_left_to_processor(const input::Case& data) {
  std::vector<std::string> stages;
  if (mpm::get_device_name().empty()) return stages;
  const bool wet = std::any_of(data.materials.begin(), data.materials.end(),
                               [](const auto& entry) { return entry.second.water.is_wet(); });
  for (const input::Stage& stage : data.stages)
    if (wet && stage.step.water == input::WaterMotion::flows) stages.push_back(stage.name);
  return stages;
}

}  // namespace talus::run
