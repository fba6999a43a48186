// SPDX-License-Identifier: MIT
#pragma once
// Faults of the regions of a section whose ground is sound.

#include <string>
#include <vector>

#include "lem/section/section.hpp"

namespace talus::lem {

/// Adds a sentence per polygon that crosses itself or lies outside, and per place under the ground without soil.
void find_region_faults(const Section& section, std::vector<std::string>& faults);

}  // namespace talus::lem
