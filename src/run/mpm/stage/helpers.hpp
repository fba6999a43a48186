// SPDX-License-Identifier: MIT
#pragma once
// The ranks without a body of their own: they step their parts of the stages of rank 0.

#include <memory>

#include "base/error.hpp"
#include "input/case/case.hpp"
#include "mpm/state/body.hpp"
#include "run/mpm/stage/stepped_body.hpp"

namespace talus::run {

/// Throws Error if the bodies differ between ranks. Every rank has prepared the body by itself, and another program or
/// library would prepare another one.
template <int D>
void check_equal(const mpm::Body<D>& body);

/// The ranks other than 0 while they have no body and wait in help_with_stages(). Rank 0 scatters their parts when a
/// stage starts.
template <int D>
class Helpers {
 public:
  /// Starts a stage of a body that only rank 0 has: sends all but the parts to the other ranks.
  void begin(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state, const HooksOfRank0& hooks);
  /// Must follow the end of the stage. A failure within a stage is known on all ranks already.
  void end() { knows_failure_ = false; }
  /// Ends help_with_stages() on the other ranks, because there are no more stages or because rank 0 has failed between
  /// two stages.
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
