// SPDX-License-Identifier: MIT
#pragma once
// A body of the engine whose steps a device takes.

#include <memory>
#include <string>

#include "mpm/device/device.hpp"
#include "mpm/device/emulated.hpp"
#include "mpm/step/critical_step.hpp"

namespace talus::mpm {

// Which device takes the bodies of this process through their steps.

/// From now on a GPU does. Throws Error (wrong_input) where there is none.
void use_gpu();
/// The kernels of a GPU run on this processor.
void use_emulated_device(const Emulation& how = {});
/// This processor does again.
void use_no_device();

/// "NVIDIA H100", "emulated"; empty where no device is used.
const std::string& get_device_name();

/// A new device of the chosen kind, nullptr where none is.
template <int D>
std::unique_ptr<Device<D>> make_device();

template <int D>
class DeviceStepper {
 public:
  explicit DeviceStepper(std::unique_ptr<Device<D>> device) : device_(std::move(device)) {}

  /// As step() does: of the body only time, step_count, lost, work and monitor go on. Takes the body over first where
  /// the host has changed it.
  void step(Body<D>& body, const StepOptions<D>& options);
  void fade_unseen(Body<D>& body);
  /// Brings all of the body up to date. The device still has it.
  void bring_back(Body<D>& body);
  /// The body was changed on the host, or put in the place of another.
  void note_change() {
    device_has_body_ = false;
    host_is_up_to_date_ = true;
  }
  /// find_critical_step().
  CriticalStep find_critical_step(Body<D>& body, const StepOptions<D>& options);
  /// mpm::observe().
  Observation<D> observe(const Body<D>& body, const Vec<D>& gravity, const std::vector<int>& points);
  /// Of a point that is on the grid, from its reference [m].
  double find_largest_displacement(const Body<D>& body);
  /// From now on kernels are timed.
  void time_kernels() { device_->time_kernels(); }
  std::vector<KernelTime> list_times() { return device_->list_times(); }

 private:
  void take(Body<D>& body, const StepOptions<D>& options);
  DeviceInput<D> make_input(const Body<D>& body, const StepOptions<D>& options);

  std::unique_ptr<Device<D>> device_;
  DeviceImage<D> image_;
  int threads_ = 1;
  bool device_has_body_ = false, host_is_up_to_date_ = true;
};

}  // namespace talus::mpm
