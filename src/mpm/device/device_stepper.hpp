// SPDX-License-Identifier: MIT
#pragma once
// A body of the engine whose steps a device takes.

#include <memory>
#include <string>

#include "mpm/device/device.hpp"
#include "mpm/step/critical_step.hpp"

namespace talus::mpm {

/// Why a device cannot take a body through such steps, in words that follow "because"; empty: it can.
template <int D>
std::string find_hindrance(const Body<D>& body, const StepOptions<D>& options);

template <int D>
class DeviceStepper {
 public:
  explicit DeviceStepper(std::unique_ptr<Device<D>> device) : device_(std::move(device)) {}

  /// step(): of the body only time, step_count, lost, work and monitor go on. Takes the body over first where the host
  /// has changed it.
  void step(Body<D>& body, const StepOptions<D>& options);
  void fade_unseen(Body<D>& body);
  /// Brings all of the body up to date. The device still has it.
  void bring_back(Body<D>& body);
  /// The body was changed on the host after it was brought back.
  void note_change() { device_has_body_ = false; }
  /// find_critical_step().
  CriticalStep find_critical_step(const Body<D>& body, const StepOptions<D>& options);

 private:
  void take(const Body<D>& body, const StepOptions<D>& options);
  DeviceInput<D> make_input(const Body<D>& body, const StepOptions<D>& options);

  std::unique_ptr<Device<D>> device_;
  DeviceImage<D> image_;
  std::vector<Vec<D>> load_;
  bool device_has_body_ = false, host_is_up_to_date_ = true, load_is_known_ = false;
};

}  // namespace talus::mpm
