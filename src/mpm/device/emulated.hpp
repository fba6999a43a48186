// SPDX-License-Identifier: MIT
#pragma once
// The kernels of a GPU on this processor: slow, and the same numbers.

#include "mpm/device/device.hpp"

namespace talus::mpm {

struct Emulation {
  bool backwards = false;  ///< threads run in the opposite order, which must change nothing
  int threads = 1;         ///< of the processor, which take the blocks of a launch in turns
  int block = 128;         ///< threads of a launch that run one after the other; 1: neighbours never do
  std::size_t memory = 0;  ///< that the device has [bytes]; 0: all there is
  int launches = 0;        ///< after so many kernels the device is lost; 0: never
};

template <int D>
std::unique_ptr<Device<D>> make_emulated_device(const Emulation& how = {});

}  // namespace talus::mpm
