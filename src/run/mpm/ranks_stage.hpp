// SPDX-License-Identifier: MIT
#pragma once
// A stage on several ranks: each advances its share of the body, and rank 0 records the whole one.

#include <functional>
#include <memory>

#include "base/error.hpp"
#include "mpm/body/body.hpp"
#include "run/mpm/stage.hpp"

namespace talus::run {

// Hands chunks on between ranks where some have more to do than others, as the soil moves or parts of it cost more.

/// Of one stage. Numbers do not depend on which rank has a chunk, so nothing but time does on what is measured.
template <int D>
class LoadBalance {
 public:
  /// `whole`: on rank 0 the body that the shares were taken of, which is put together in between.
  LoadBalance(mpm::Body<D>* whole, const mpm::Body<D>& share);

  /// At every look, by all ranks: measures what each has done, and takes another share where that saves time.
  void look(mpm::Body<D>& share);
  /// Does work that is no part of the steps, such as an output: what is waited for in it says nothing of them.
  void leave_out(const std::function<void()>& work);

 private:
  mpm::Body<D>* whole_;
  int looks_ = 0;
  double spent_ = 0, sent_ = 0;  ///< when it was measured last [s]
  double cost_ = 0;              ///< of the last hand-over [s]
};

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
