// SPDX-License-Identifier: MIT
#include "run/mpm/record/onset.hpp"

#include <algorithm>

#include "base/units.hpp"
#include "output/files/history.hpp"

namespace talus::run {

std::optional<double> find_failure_time(const std::filesystem::path& history, double displacement) {
  if (!std::filesystem::exists(history)) return std::nullopt;
  const output::HistoryTable table = output::read_history(history);
  const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                   [](const output::Column& c) { return c.name == "largest_displacement"; });
  if (column == table.columns.end()) return std::nullopt;
  const std::vector<double>& time = table.values.front();
  const std::vector<double>& shown = table.values[static_cast<std::size_t>(column - table.columns.begin())];
  const double limit = displacement / units::get_si_factor(column->unit);
  if (shown.empty() || !(shown.back() >= limit)) return std::nullopt;
  std::size_t i = shown.size() - 1;
  while (i > 0 && shown[i - 1] >= limit) --i;
  if (i == 0) return std::nullopt;
  const double share = (limit - shown[i - 1]) / (shown[i] - shown[i - 1]);
  return time[i - 1] + share * (time[i] - time[i - 1]);
}

}  // namespace talus::run
