// SPDX-License-Identifier: MIT
#pragma once
// Rain that cannot enter: it stands on the ground up to a depth, runs down to where it can enter, or away.
// Internal to fem/; docs/theory/13-seepage.md.

#include "fem/seepage/newton.hpp"

namespace talus::fem {

/// The ground as nodes that hand on water, each to its steepest neighbour below. Water takes no time on its way.
template <int D>
class Runoff {
 public:
  explicit Runoff(const SeepageSystem<D>& system);

  /// Whether any boundary asks for it.
  bool is_used() const { return used_; }
  /// Adds what runs on and what stands to what is offered in a step of `dt` [s].
  void offer(double dt, std::vector<NodeCondition>& conditions) const;
  /// Hands on what did not enter by a solution with `conditions`, that offer() has been given. True when each node is
  /// given what it was offered.
  bool route(double dt, const std::vector<NodeCondition>& conditions, const SeepageState& state, const NodalSums& sums);
  /// Ends a step: what stands, for the next one, and its growth in `result`.
  void end_step(double dt, const std::vector<NodeCondition>& conditions, SeepageResult<D>& result);

 private:
  const SeepageSystem<D>& system_;
  bool used_ = false;
  std::vector<int> receiver_;           ///< by unknown; -1: its water leaves the ground
  std::vector<int> order_;              ///< unknowns of the ground, each before its receiver
  std::vector<double> capacity_;        ///< that may stand, by unknown [m³]
  std::vector<double> standing_, now_;  ///< at the start and at the end of the step [m³]
  std::vector<double> run_on_, next_;   ///< as offered, and as handed on [m³/s]
};

}  // namespace talus::fem
