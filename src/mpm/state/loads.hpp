// SPDX-License-Identifier: MIT
#pragma once
// Nodal forces of tractions.

#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Nodal forces of the tractions (2.37) for the step that starts at body.time. Writes nodes.load.
template <int D>
void gather_loads(Body<D>& body);

}  // namespace talus::mpm
