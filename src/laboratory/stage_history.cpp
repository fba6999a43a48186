// SPDX-License-Identifier: MIT
#include "laboratory/stage_history.hpp"

#include "base/error.hpp"
#include "run/construction/construction_run.hpp"

namespace talus::laboratory {

StageHistory::StageHistory(const input::Case& data) {
  run::RunOptions options;
  options.threads = 1;
  const input::LoadedCase unused;  // the case as it was written, which files and factors need
  run::ConstructionRun run(unused, data, options, "");
  run.prepare();
  results::Construction found = run.follow();
  times_.push_back(0);
  for (const results::ConstructionStage& stage : found.stages)
    for (const results::ConstructionStep& step : stage.steps) times_.push_back(step.time);
  if (times_.size() < 2) fail_input("the first stage of construction has no step in equilibrium");
  monitors_ = std::move(found.monitors);
}

std::vector<double> StageHistory::list_values(std::size_t monitor, input::MonitoredQuantity quantity) const {
  const results::ConstructionMonitor& m = monitors_[monitor];
  const bool is_pressure = quantity == input::MonitoredQuantity::pressure;
  const std::vector<double>& computed = is_pressure                                     ? m.pressure
                                        : quantity == input::MonitoredQuantity::lateral ? m.displacement_x
                                                                                        : m.displacement_y;
  const double sign = quantity == input::MonitoredQuantity::settlement ? -1 : 1;
  // Until the first step ends, pressures are taken as those of its end.
  std::vector<double> values{(is_pressure ? 1 : 0) * computed.front()};
  for (const double v : computed) values.push_back(sign * v);
  return values;
}

}  // namespace talus::laboratory
