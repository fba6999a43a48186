// SPDX-License-Identifier: MIT
#include "input/language/time_table.hpp"

#include <algorithm>

namespace talus::input {

double TimeTable::at(double t) const {
  if (time.empty()) return 1;
  if (t < time.front()) return value.front();
  if (t >= time.back()) return value.back();  // of several rows at the last time, the last one
  const auto after = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
  return value[after - 1] + share * (value[after] - value[after - 1]);
}

}  // namespace talus::input
