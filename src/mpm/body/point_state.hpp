// SPDX-License-Identifier: MIT
#pragma once
// State variables of single points between steps; view_point() reads all of a point.

#include "mpm/body/body.hpp"

namespace talus::mpm {

/// Overwrites the state variables of a point that is present, in the order of its law. `state`: as many as it has.
template <int D>
void write_state(Body<D>& body, int id, const double* state);

/// E_c of the point whose fields begin at `p`, with the law of its material [Pa].
template <int D>
double find_modulus(const material::Law& law, const double* p) {
  using P = Points<D>;
  double sigma[P::stress_size], state[material::max_state_size];
  for (int i = 0; i < P::stress_size; ++i) sigma[i] = p[(P::stress + i) * lane_width];
  for (int i = 0; i < material::state_size(law); ++i) state[i] = p[(P::state + i) * lane_width];
  return material::constrained_modulus(law, sigma, state);
}

}  // namespace talus::mpm
