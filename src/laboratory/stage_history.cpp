// SPDX-License-Identifier: MIT
#include "laboratory/stage_history.hpp"

#include <algorithm>

#include "run/construction/construction_run.hpp"

namespace talus::laboratory {

StageHistory::StageHistory(const input::Case& data) {
  run::RunOptions options;
  options.threads = 1;
  const input::LoadedCase unused;  // the case as it was written, which files and factors need
  run::ConstructionRun run(unused, data, options, "");
  run.prepare();
  results::Construction found = run.follow();
  for (const results::ConstructionStage& stage : found.stages)
    for (const results::ConstructionStep& step : stage.steps) times_.push_back(step.time);
  monitors_ = std::move(found.monitors);
}

std::vector<double> StageHistory::list_values(std::size_t monitor, input::MonitoredQuantity quantity) const {
  const results::ConstructionMonitor& m = monitors_[monitor];
  switch (quantity) {
    case input::MonitoredQuantity::lateral:
      return m.displacement_x;
    case input::MonitoredQuantity::pressure:
      return m.pressure;
    case input::MonitoredQuantity::settlement:
      break;
  }
  std::vector<double> settlement = m.displacement_y;
  for (double& v : settlement) v = -v;
  return settlement;
}

HistoryReading read_history(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (at >= x.back()) return {y.back(), at - x.back()};
  if (at <= x.front()) return {y.front(), x.front() - at};
  const auto after = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  const double share = (at - x[after - 1]) / (x[after] - x[after - 1]);
  return {y[after - 1] + share * (y[after] - y[after - 1]), 0};
}

}  // namespace talus::laboratory
