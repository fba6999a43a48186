// SPDX-License-Identifier: MIT
#pragma once
// Rain that does not infiltrate: it stands on the ground up to a depth, and the rest runs down to where it infiltrates,
// or leaves the model. Internal to fem/; docs/theory/13-seepage.md.

#include "fem/seepage/newton.hpp"

namespace talus::fem {

/// The ground as nodes, each of which drains to its steepest neighbour below. The travel time is zero.
template <int D>
class Runoff {
 public:
  explicit Runoff(const SeepageSystem<D>& system);

  /// Returns true if any boundary uses it.
  bool is_used() const { return used_; }
  /// Adds run-on and standing water to the rain supplied in a step of `dt` [s].
  void offer(double dt, std::vector<NodeCondition>& conditions) const;
  /// Routes the water that did not infiltrate in a solution with the `conditions` from offer(). Returns true if the
  /// run-on of every node agrees with its supply.
  bool route(double dt, const std::vector<NodeCondition>& conditions, const SeepageState& state, const NodalSums& sums);
  /// Ends a step: stores the standing water for the next one, and writes its growth into `result`.
  void end_step(double dt, const std::vector<NodeCondition>& conditions, SeepageResult<D>& result);

 private:
  const SeepageSystem<D>& system_;
  bool used_ = false;
  std::vector<int> receiver_;           ///< by unknown; -1: the water leaves the ground
  std::vector<int> order_;              ///< unknowns of the ground, each before its receiver
  std::vector<double> capacity_;        ///< limit of the standing water, by unknown [m³]
  std::vector<double> standing_, now_;  ///< standing water at the start and at the end of the step [m³]
  std::vector<double> run_on_, next_;   ///< run-on as supplied, and as routed [m³/s]
};

}  // namespace talus::fem
