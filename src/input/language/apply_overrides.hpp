// SPDX-License-Identifier: MIT
#pragma once
// Overrides on their way into the table of a case file.

#include <toml++/toml.h>

#include <vector>

#include "input/language/findings.hpp"
#include "input/language/overrides.hpp"

namespace talus::input {

/// Writes the overrides into the table, and tells `findings` where they went and which of them are impossible.
void apply_overrides(toml::table& root, const std::vector<Override>& overrides, Findings& findings);

}  // namespace talus::input
