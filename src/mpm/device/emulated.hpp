// SPDX-License-Identifier: MIT
#pragma once
// The kernels of a GPU on this processor, one thread after the other: slow, and the same numbers.

#include "mpm/device/device.hpp"

namespace talus::mpm {

/// `backwards`: threads run in the opposite order, which must change nothing.
template <int D>
std::unique_ptr<Device<D>> make_emulated_device(bool backwards = false);

}  // namespace talus::mpm
