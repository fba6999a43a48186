// SPDX-License-Identifier: MIT
#pragma once
// Monitors through the stages of construction of a case, for the fit of its soils to measurements.

#include <optional>
#include <string>
#include <vector>

#include "input/case/case.hpp"
#include "results/construction.hpp"

namespace talus::laboratory {

/// Monitored quantities over time.
class StageHistory {
 public:
  /// Computes the stages of `data` on one thread. Throws Error (wrong_input) if not one of their steps is in
  /// equilibrium, and what ConstructionRun throws.
  explicit StageHistory(const input::Case& data);

  /// The start and the times of the steps [s], not decreasing.
  const std::vector<double>& times() const { return times_; }
  /// Values of a monitor at these times, with the signs of its measurements [SI]: displacements from zero
  /// on. NaN where no soil is.
  std::vector<double> list_values(std::size_t monitor, input::MonitoredQuantity quantity) const;

 private:
  std::vector<double> times_;
  std::vector<results::ConstructionMonitor> monitors_;
};

}  // namespace talus::laboratory
