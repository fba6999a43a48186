// SPDX-License-Identifier: MIT
#pragma once
// How a stage that became unstable goes back to its last good state, and on with a smaller step.

#include <memory>
#include <string>

#include "run/mpm/stage.hpp"

namespace talus::run {

/// An unstable stage is calculated again at most this often.
inline constexpr std::size_t most_setbacks = 3;

/// The plan after so many setbacks: half the time step for each, and without smoothing that may be the cause. With
/// flowing pore water that is any smoothing; without it plain strain smoothing, and from the second setback on any.
template <int D>
StagePlan<D> calm_down(StagePlan<D> plan, std::size_t setbacks, bool wet);

/// The states of a stage to which it may go back: its start, and two more that are kept while it runs.
template <int D>
class GoodStates {
 public:
  GoodStates(const StagePlan<D>& plan, const StageHooks<D>& hooks) : plan_(plan), hooks_(hooks) {}

  /// Keeps a copy of the body as it is now.
  void keep(const mpm::Body<D>& body, const StageState& state);
  /// The newest one that is old enough to be called good.
  const mpm::Body<D>& good_body() const { return older_->body; }
  const StageState& good_state() const { return older_->state; }

  /// Puts body, state and what was recorded back to the last good state, and tells of it in state.setbacks: `reason`.
  /// False where the stage was put back often enough, or would be without end.
  bool go_back(mpm::Body<D>& body, StageState& state, const std::string& reason);

 private:
  struct Kept {
    mpm::Body<D> body;
    StageState state;
    GoBack<D> go_back;
  };
  const StagePlan<D>& plan_;
  const StageHooks<D>& hooks_;
  std::shared_ptr<const Kept> start_, older_, newer_;  ///< may be one and the same
};

}  // namespace talus::run
