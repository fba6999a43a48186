// SPDX-License-Identifier: MIT
#pragma once
// Factor of safety of a state of consolidation against failure without drainage (docs/theory/26-consolidation.md).

#include "fem/consolidation/consolidation.hpp"

namespace talus::fem {

struct UndrainedOptions {
  double resolution = 0.01;      ///< of the factor [-]
  double largest_factor = 10;    ///< beyond it none is looked for
  double most_displacement = 0;  ///< in a trial [m]
  int most_iterations = 25;      ///< of a step
  int threads = 0;               ///< 0: all of the machine
};

struct UndrainedReduction {
  double stable = 0;  ///< largest factor with equilibrium; 0: there is none at full strength
  double failed = 0;  ///< smallest factor without; 0: none was found up to the largest one
  int trials = 0;
};

/// Reduces the strength of the soil from `state` while no pore water flows: soil that contracts as it yields takes up
/// pore pressure, which a reduction at fixed pore pressures leaves out. Each trial starts from the state itself. Throws
/// what run_stage() throws.
template <int D>
UndrainedReduction reduce_undrained(ConsolidationModel<D> model, const ConsolidationState<D>& state,
                                    const UndrainedOptions& options);

}  // namespace talus::fem
