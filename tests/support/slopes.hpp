// SPDX-License-Identifier: MIT
#pragma once
// Slopes of several tests: the case files of tests/support/slopes, and changes to them.

#include <string>
#include <vector>

#include "input/read.hpp"

namespace talus::support {

/// Returns the text of slopes/NAME.toml; with changes as by --set ("mesh.size=2") an equivalent text with sorted keys.
std::string write_slope(const std::string& name, const std::vector<std::string>& changes = {});

}  // namespace talus::support
