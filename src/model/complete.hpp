#pragma once
// What follows from several keys of a case, before it is checked.

#include <string>

#include "model/case.hpp"
#include "model/findings.hpp"

namespace talus::model {

/// Files relative to the folder of the case file `file`, porosities, densities of soils that are given by their unit
/// weight, and what a case without material points leaves out: box, element size, supports.
void complete(Case& data, const std::string& file, const Places& places);

}  // namespace talus::model
