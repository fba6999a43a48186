// SPDX-License-Identifier: MIT
#pragma once
// How a case is run.

#include <filesystem>
#include <string>

#include "base/progress.hpp"

namespace talus::run {

/// What takes bodies of points through their steps.
enum class DeviceKind {
  cpu,
  gpu,
  emulated  ///< the kernels of a GPU on this processor: for tests
};

struct RunOptions {
  std::filesystem::path folder;  ///< where results go; made when it does not exist
  int threads = 1;
  DeviceKind device = DeviceKind::cpu;
  bool resume = false;           ///< go on from the folder's checkpoint; a finished run is not run again
  bool overwrite = false;        ///< replace results that are there
  Progress* progress = nullptr;  ///< where progress is shown, or nowhere
  std::string label;             ///< before the name of a stage in the line of progress
};

}  // namespace talus::run
