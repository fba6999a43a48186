// SPDX-License-Identifier: MIT
#include "fem/consolidation/undrained_factor.hpp"

namespace talus::fem {

template <int D>
UndrainedReduction reduce_undrained(ConsolidationModel<D> model, const ConsolidationState<D>& state,
                                    const UndrainedOptions& options) {
  constexpr double growth = 1.25;
  model.drainage = StageDrainage::undrained;
  model.is_jacking = false;
  ConsolidationSchedule schedule;
  schedule.most_halvings = 0;  // a trial creeps to rest, or fails
  schedule.most_iterations = options.most_iterations;
  schedule.most_displacement = options.most_displacement;
  schedule.threads = options.threads;
  UndrainedReduction found;
  const auto holds = [&](double factor) {
    ++found.trials;
    model.strength_factor = factor;
    return run_stage<D>(model, state, schedule).converged;
  };
  double factor = 1;
  while (factor < options.largest_factor && holds(factor)) {
    found.stable = factor;
    factor *= growth;
  }
  if (factor < options.largest_factor) found.failed = factor;
  if (found.stable == 0 || found.failed == 0) return found;
  while (found.failed - found.stable > options.resolution) {
    const double middle = 0.5 * (found.stable + found.failed);
    (holds(middle) ? found.stable : found.failed) = middle;
  }
  return found;
}

template UndrainedReduction reduce_undrained<2>(ConsolidationModel<2>, const ConsolidationState<2>&,
                                                const UndrainedOptions&);
template UndrainedReduction reduce_undrained<3>(ConsolidationModel<3>, const ConsolidationState<3>&,
                                                const UndrainedOptions&);

}  // namespace talus::fem
