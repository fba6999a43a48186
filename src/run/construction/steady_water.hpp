// SPDX-License-Identifier: MIT
#pragma once
// The steady flow under the boundary conditions of a stage, from which its excess pressures are counted.

#include <optional>
#include <string>
#include <vector>

#include "run/construction/stage_model.hpp"

namespace talus::run {

/// Heads of steady flow in time.
class SteadyWater {
 public:
  /// `stage` must outlive this object. `kept`: heads per node where nothing gives one [m]. `from`, `to`: times between
  /// which they are needed [s].
  SteadyWater(const StageModel& stage, std::vector<double> kept, double from, double to);

  /// Returns the heads per node at a time [m]: those of the last time, or `kept`, where no steady flow is found.
  const std::vector<double>& find_head(double time);
  /// Returns the heads of a drained stage at its end [m]. Throws as fem::solve_steady_seepage().
  const std::vector<double>& find_drained_head();

  /// Returns why heads are not those of steady flow; nullopt if they are.
  const std::optional<std::string>& fault() const { return fault_; }

 private:
  bool varies() const;
  void solve(double time);

  const StageModel& stage_;
  const std::vector<double> kept_;
  const double from_, to_;
  std::vector<double> head_;
  std::optional<double> time_;  ///< of `head_`; without, it is `kept_`
  std::optional<std::string> fault_;
};

}  // namespace talus::run
