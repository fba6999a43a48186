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
  /// Computes the stages of `data` on one thread. Throws Error, also one of a case that cannot be computed.
  explicit StageHistory(const input::Case& data);

  /// Times of the steps [s], not decreasing.
  const std::vector<double>& times() const { return times_; }
  /// Values of a monitor at these times, with the signs of its measurements [SI]; NaN where no soil is.
  std::vector<double> list_values(std::size_t monitor, input::MonitoredQuantity quantity) const;

 private:
  std::vector<double> times_;
  std::vector<results::ConstructionMonitor> monitors_;
};

/// A value on a line through points in the order of x; beyond its last point the value there, and its distance.
struct HistoryReading {
  double value = 0, missing = 0;
};
HistoryReading read_history(const std::vector<double>& x, const std::vector<double>& y, double at);

}  // namespace talus::laboratory
