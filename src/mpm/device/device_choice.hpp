// SPDX-License-Identifier: MIT
#pragma once
// Which device takes the bodies of this process through their steps.

#include "mpm/device/emulated.hpp"

namespace talus::mpm {

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

}  // namespace talus::mpm
