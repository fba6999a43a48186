// SPDX-License-Identifier: MIT
#pragma once
// Choice of the device for MPM, and the stepper that runs the steps of a body on it.

#include <memory>
#include <string>

#include "mpm/backend/device.hpp"
#include "mpm/backend/emulated.hpp"
#include "mpm/solver/step.hpp"

namespace talus::mpm {

// Device for the bodies of this process.

/// Selects the GPU. Throws Error (wrong_input) if there is none.
void use_gpu();
/// Selects the emulated device: GPU kernels on the CPU. Throws Error (wrong_input) if its library is not built.
void use_emulated_device(const Emulation& how = {});
/// Selects the CPU.
void use_no_device();

/// "NVIDIA H100", "emulated"; empty where no device is used.
const std::string& get_device_name();

/// Returns a new device of the selected kind; nullptr for the CPU.
template <int D>
std::unique_ptr<Device<D>> make_device();

template <int D>
class DeviceStepper {
 public:
  explicit DeviceStepper(std::unique_ptr<Device<D>> device) : device_(std::move(device)) {}

  /// Like mpm::step(), but updates only time, step_count, lost, work and monitor of the host's body. First copies the
  /// body to the device if the host has changed it.
  void step(Body<D>& body, const StepOptions<D>& options);
  void filter_null_modes(Body<D>& body);
  /// Copies the whole state back to the host's body. The device keeps its copy.
  void copy_back(Body<D>& body);
  /// Must be called after the body was changed on the host or replaced.
  void note_change() {
    device_has_body_ = false;
    host_is_up_to_date_ = true;
  }
  CriticalStep find_critical_step(Body<D>& body, const StepOptions<D>& options);
  Observation<D> observe(const Body<D>& body, const Vec<D>& gravity, const std::vector<int>& points);
  /// Largest displacement from the reference of a point on the grid [m].
  double find_largest_displacement(const Body<D>& body);
  /// Starts to time kernels.
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
