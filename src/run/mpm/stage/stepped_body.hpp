// SPDX-License-Identifier: MIT
#pragma once
// The body that the steps of a stage advance, and how its state reaches the hooks, which know the body of the case.

#include <list>
#include <memory>
#include <string>
#include <vector>

#include "run/mpm/stage/hooks.hpp"
#include "run/mpm/stage/partitioned_body.hpp"
#include "run/mpm/stage/stepper.hpp"

namespace talus::run {

/// The hooks that rank 0 has. All ranks must take part in them.
struct HooksOfRank0 {
  bool output = false, look = false, report = false, save_last_good = false, mark = false;
};

/// The body that is stepped: that of the case, or a body made from it where the stage requires that, one after the
/// other: the drained body (fixed pore pressures), the equalised-mass body, and the part of this rank. Hooks are called
/// on rank 0 with the body of the case in the state of the stepped one. With several ranks all functions are
/// collective.
template <int D>
class SteppedBody {
 public:
  /// `body`, the body of the case, and `hooks` must outlive this object. `state`: of the stage before its first step,
  /// or of a checkpoint.
  SteppedBody(mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state, const StageHooks<D>& hooks);
  /// The part of a rank without a body and without hooks (help_with_stages()).
  SteppedBody(mpm::Body<D> description, const StagePlan<D>& plan, const HooksOfRank0& hooks);
  SteppedBody(const SteppedBody&) = delete;
  SteppedBody& operator=(const SteppedBody&) = delete;

  mpm::Body<D>& body() { return part_ ? part_->part() : *bodies_.back(); }
  /// The plan for this body.
  const StagePlan<D>& plan() const { return plan_; }

  void rebalance();
  /// Calls the hooks `output`, `look` and `report` where they are due.
  void write_output(Stepper<D>& stepper, StageState& state);
  void look(Stepper<D>& stepper, const StageState& state);
  bool is_report_due();
  void report(const StageState& state, double moved);
  /// Returns where the body was saved; empty without the hook.
  std::string save_last_good(const mpm::Body<D>& good, const StageState& state);
  GoBack<D> mark();

  /// Brings the body of the case up to date at the end of the stage.
  void finish();

 private:
  /// Calls `work` on rank 0 with the body of the case in the state of `stepped`, which is that of body().
  void lead(const mpm::Body<D>& stepped, const std::function<void(const mpm::Body<D>&)>& work);
  const mpm::Body<D>& update_case(const mpm::Body<D>& whole);
  /// Returns the value of rank 0.
  bool agree(bool value);

  StagePlan<D> plan_;
  const StageHooks<D> no_hooks_{};
  const StageHooks<D>& hooks_;
  HooksOfRank0 called_;
  std::list<mpm::Body<D>> auxiliary_;
  std::vector<mpm::Body<D>*> bodies_;  ///< that of the case, then the auxiliary bodies, each made from the one before
  std::unique_ptr<PartitionedBody<D>> part_;  ///< of the last body; null on a single rank
};

}  // namespace talus::run
