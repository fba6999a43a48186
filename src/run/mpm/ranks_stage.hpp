// SPDX-License-Identifier: MIT
#pragma once
// A stage on several ranks: each advances its share of the body, and rank 0 records the whole one.

#include <memory>

#include "base/error.hpp"
#include "run/mpm/stage.hpp"

namespace talus::run {

/// run_stage() of a body that every rank has as a whole, and has again at the end; or, where the plan has helpers, that
/// rank 0 alone has. Hooks are those of rank 0. What a hook throws there is thrown on all ranks.
template <int D>
results::StageEnd run_on_ranks(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                               const StageHooks<D>& hooks);

/// The ranks beside rank 0 while they have no body of their own and wait in help_with_stages(): rank 0 gives them their
/// parts when a stage begins.
template <int D>
class Helpers {
 public:
  /// A stage of a body that rank 0 alone has.
  results::StageEnd run(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state, const StageHooks<D>& hooks);
  /// There are no more stages, or rank 0 has failed between two. Where a stage failed all ranks know it.
  void dismiss(const Failure& failure);

 private:
  std::shared_ptr<const mpm::Layout<D>> layout_;  ///< that they have
  bool knows_failure_ = false;
};

/// Advances shares of bodies until rank 0 dismisses this rank. `data`: the case of rank 0. Throws what stages throw,
/// and an Error with the words of what rank 0 was dismissed with.
template <int D>
void help_with_stages(const input::Case& data);

}  // namespace talus::run
