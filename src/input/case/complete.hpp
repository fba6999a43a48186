// SPDX-License-Identifier: MIT
#pragma once
// What follows from several keys of a case, before it is checked.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

/// Files relative to the folder of the case file `file`, porosities, densities of soils that are given by their unit
/// weight, and what a case without material points leaves out: box, element size, supports.
void complete(Case& data, const std::string& file, const Places& places);

/// The porosities that belong to given void ratios.
void complete_porosities(Case& data);

// Combinations of keys that are known to ruin a calculation, and what is calculated instead.

/// Replaces what is known to be harmful in stages and in the trials of the displacement curve, and tells of each in a
/// sentence: what, where, why, and what is calculated instead. The echo and all methods then see what is calculated.
std::vector<std::string> replace_harmful(Case& data);

}  // namespace talus::input
