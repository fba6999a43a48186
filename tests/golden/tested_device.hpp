// SPDX-License-Identifier: MIT
#pragma once
// The device that the tests of devices run on: emulated, or the GPU where TALUS_TEST_DEVICE=gpu is set.

#include <cstdlib>
#include <memory>
#include <string>

#include "mpm/solver/device_stepper.hpp"

namespace talus::golden {

/// Value of --device in the tests.
inline std::string find_tested_device() {
  const char* chosen = std::getenv("TALUS_TEST_DEVICE");
  return chosen != nullptr ? chosen : "emulated";
}

inline bool tests_gpu() {
  return find_tested_device() == "gpu";
}

/// Returns a device; `how` describes an emulated one.
template <int D>
std::unique_ptr<mpm::Device<D>> make_tested_device(const mpm::Emulation& how) {
  if (!tests_gpu()) return mpm::make_emulated_device<D>(how);
  mpm::use_gpu();
  return mpm::make_device<D>();
}

}  // namespace talus::golden
