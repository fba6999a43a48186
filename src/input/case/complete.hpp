// SPDX-License-Identifier: MIT
#pragma once
// What follows from several keys of a case, before it is checked.

#include <string>

#include "input/case/case.hpp"
#include "input/language/findings.hpp"

namespace talus::input {

/// Files relative to the folder of the case file `file`, porosities, densities of soils that are given by their unit
/// weight, and what a case without material points leaves out: box, element size, supports.
void complete(Case& data, const std::string& file, const Places& places);

/// The porosities that belong to given void ratios.
void complete_porosities(Case& data);

}  // namespace talus::input
