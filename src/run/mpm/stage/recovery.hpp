// SPDX-License-Identifier: MIT
#pragma once
// Recovery of an unstable stage: detection, copies of good states, and the retry with a smaller step.

#include <memory>
#include <optional>
#include <string>

#include "run/mpm/stage/stepped_body.hpp"

namespace talus::run {

/// Place and velocity of an unstable motion.
template <int D>
struct Runaway {
  Vec<D> place{};    ///< [m]
  double speed = 0;  ///< [m/s]
  std::string what;  ///< "the grid", "a point that left the grid"
};

/// The retries of one stage. An unstable stage is repeated from its last good state with the plan of make_retry_plan(),
/// and the retry is recorded in state.setbacks. After the last retry it throws Error (unstable) with place and reason.
template <int D>
class Recovery {
 public:
  /// Keeps the present state as the first good one. The arguments must outlive this object.
  Recovery(SteppedBody<D>& stepped, Stepper<D>& stepper, StageState& state);

  /// The plan after the retries so far.
  const StagePlan<D>& plan() const { return plan_; }

  /// Copies the present state, at some of the looks.
  void keep_at_look();
  /// Retries the stage if this step is far below that of the mesh, as soil that swells makes it. Returns true if it
  /// did.
  bool retry_below_smallest_step(const mpm::CriticalStep& critical);
  /// Retries the stage if a node in the last step, if it was monitored, or a point that left the grid since
  /// `lost_before` moves faster than waves. Returns true if it did. Throws Error (unstable) if a UMAT failed.
  bool retry_above_wave_speed(bool monitored, std::size_t lost_before);

 private:
  struct Good {
    mpm::Body<D> body;
    StageState state;
    GoBack<D> go_back;
  };
  void keep();
  void retry(const Runaway<D>& runaway);
  std::optional<Runaway<D>> find_runaway(bool monitored, std::size_t lost_before) const;
  void check_external_models();
  std::string save_last_good() { return stepped_.save_last_good(older_->body, older_->state); }
  [[noreturn]] void throw_unstable(const std::string& reason);

  SteppedBody<D>& stepped_;
  Stepper<D>& stepper_;
  mpm::Body<D>& body_;
  StageState& state_;
  StagePlan<D> plan_;
  double smallest_step_;
  std::shared_ptr<const Good> start_, older_, newer_;  ///< may be identical
};

}  // namespace talus::run
