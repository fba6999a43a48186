// SPDX-License-Identifier: MIT
#pragma once
// Combinations of keys that are known to ruin a calculation, and what is calculated instead.

#include <string>
#include <vector>

#include "input/case/case.hpp"

namespace talus::input {

/// Replaces what is known to be harmful in stages and in the trials of the displacement curve, and tells of each in a
/// sentence: what, where, why, and what is calculated instead. The echo and all methods then see what is calculated.
std::vector<std::string> replace_harmful(Case& data);

}  // namespace talus::input
