// SPDX-License-Identifier: MIT
#pragma once
// The device of a run.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "run/options.hpp"

namespace talus::run {

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
