// SPDX-License-Identifier: MIT
#pragma once
// Writing the state variables of single points between steps; view_point() reads them.

#include "mpm/body/body.hpp"

namespace talus::mpm {

/// Overwrites the state variables of a point that is present, in the order of its law. `state`: as many as it has.
template <int D>
void write_state(Body<D>& body, int id, const double* state);

}  // namespace talus::mpm
