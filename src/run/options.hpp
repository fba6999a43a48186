// SPDX-License-Identifier: MIT
#pragma once
// How a case is run.

#include <filesystem>

#include "base/progress.hpp"

namespace talus::run {

struct RunOptions {
  std::filesystem::path folder;  ///< where results go; made when it does not exist
  int threads = 1;
  bool resume = false;           ///< go on from the folder's checkpoint; a finished run is not run again
  bool overwrite = false;        ///< replace results that are there
  Progress* progress = nullptr;  ///< where progress is shown, or nowhere
};

}  // namespace talus::run
