// SPDX-License-Identifier: MIT
// The plain steps, compiled once for all tests.

#include "reference/plain_mpm.hpp"
#include "reference/plain_two_phase.hpp"

namespace talus::reference {

template void step(Body<2>&, const Settings&);
template void step(Body<3>&, const Settings&);
template void step(WetBody<2>&, const WetSettings&);
template void step(WetBody<3>&, const WetSettings&);

}  // namespace talus::reference
