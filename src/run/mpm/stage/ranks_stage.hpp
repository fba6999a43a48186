// SPDX-License-Identifier: MIT
#pragma once
// A stage on several ranks: each rank advances its part of the body, and rank 0 records the gathered body. A load
// balance migrates chunks between ranks.

#include <functional>
#include <memory>

#include "base/error.hpp"
#include "mpm/state/body.hpp"
#include "run/mpm/stage/stage.hpp"

namespace talus::run {

/// Load balance of one stage: migrates chunks between ranks when the times of the ranks differ, as soil moves or a
/// part of it costs more. Results do not depend on which rank owns a chunk, so timings affect the wall-clock time
/// only.
template <int D>
class LoadBalance {
 public:
  /// `whole`: on rank 0 the body that was partitioned, used as the buffer of a migration.
  LoadBalance(mpm::Body<D>* whole, const mpm::Body<D>& share);

  /// Collective, at every look: measures the time of each rank, and repartitions the body if that saves time.
  void look(mpm::Body<D>& share);
  /// Runs work that is no part of the steps, such as an output, and excludes its waiting time from the measurement.
  void leave_out(const std::function<void()>& work);

 private:
  mpm::Body<D>* whole_;
  int looks_ = 0;
  double spent_ = 0, sent_ = 0;  ///< at the last measurement [s]
  double cost_ = 0;              ///< of the last rebalance [s]
};

/// Runs run_stage() on a partitioned body. Every rank has the whole body before and after; or, if the plan has
/// helpers, rank 0 alone. Hooks run on rank 0. An exception of a hook is rethrown on all ranks.
template <int D>
results::StageEnd run_on_ranks(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                               const StageHooks<D>& hooks);

/// The ranks other than 0 while they have no body and wait in help_with_stages(). Rank 0 scatters their parts when a
/// stage starts.
template <int D>
class Helpers {
 public:
  /// Runs a stage of a body that only rank 0 has.
  results::StageEnd run(mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state, const StageHooks<D>& hooks);
  /// Ends help_with_stages() on the other ranks, because there are no more stages or because rank 0 has failed between
  /// two stages. A failure within a stage is known on all ranks already.
  void dismiss(const Failure& failure);

 private:
  std::shared_ptr<const mpm::Layout<D>> layout_;  ///< the layout present on the helpers
  bool knows_failure_ = false;
};

/// Advances parts of bodies until rank 0 dismisses this rank. `data`: the case of rank 0. Throws what stages throw,
/// and an Error with the message of the failure on rank 0.
template <int D>
void help_with_stages(const input::Case& data);

}  // namespace talus::run
