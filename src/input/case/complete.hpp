// SPDX-License-Identifier: MIT
#pragma once
// Completion of a case by values that follow from several keys, and replacement of harmful settings.

#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

/// Completes a case before the checks: paths relative to the folder of the case file `file`, porosities, densities of
/// soils with a given unit weight, and defaults of a case without MPM: box, element size, supports.
void complete(Case& data, const std::string& file, const Places& places);

/// Sets the porosities that follow from given void ratios.
void complete_porosities(Case& data);

// Combinations of keys that are known to ruin a calculation, and their replacements.

/// Replaces harmful settings of stages and of the trials of the displacement curve and returns a sentence for each:
/// setting, place, reason and replacement. The echo and all methods use the replaced values.
std::vector<std::string> replace_harmful(Case& data);

}  // namespace talus::input
