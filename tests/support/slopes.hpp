// SPDX-License-Identifier: MIT
#pragma once
// Slopes that several tests share: the case files of tests/support/slopes, and changes to them.

#include <string>
#include <vector>

#include "input/read.hpp"

namespace talus::support {

/// The text of slopes/NAME.toml; with keys changed as by --set ("mesh.size=2"), its keys are sorted and say the same.
std::string write_slope(const std::string& name, const std::vector<std::string>& changes = {});

}  // namespace talus::support
