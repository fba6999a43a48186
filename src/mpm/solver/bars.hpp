// SPDX-License-Identifier: MIT
#pragma once
// Motion and equilibrium of the bars of a body (theory 25).

#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Brings a bar into equilibrium in soil at rest; the first piece keeps its prestress meanwhile.
void settle_bar(Bar& bar);

/// Moves the bars with the soil in the step that ended: slip and forces from the motion of the nodes, then the new
/// places. Counts the work of the bars on the soil.
void advance_bars(Body<2>& body, const StepOptions<2>& options);
inline void advance_bars(Body<3>&, const StepOptions<3>&) {}

}  // namespace talus::mpm
