// SPDX-License-Identifier: MIT
#pragma once
// Bars and walls that begin with the deformations of an earlier state. Internal to fem/.

#include <vector>

#include "fem/solid/solid.hpp"
#include "fem/solid/springs.hpp"

namespace talus::fem {

/// Sets the deformations of springs and joints (SolidState::bars) to those that are known on another mesh, linear
/// between their places; the others keep theirs.
void read_known_springs(const SpringSet& springs, const std::vector<KnownSpring>& known, std::vector<double>& bars);

}  // namespace talus::fem
