#include "input/case/case.hpp"

#include <algorithm>

namespace talus::input {

double TimeTable::at(double t) const {
  if (time.empty()) return 1;
  if (t < time.front()) return value.front();
  if (t >= time.back()) return value.back();  // of rows at one time the last one
  const auto after = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
  return value[after - 1] + share * (value[after] - value[after - 1]);
}

TimeTable Hydraulic::values() const {
  const auto choose = [&]() -> const TimeTable& {
    switch (condition) {
      case WaterCondition::total_head:
        return head;
      case WaterCondition::pressure:
        return pressure;
      default:
        return rate;
    }
  };
  if (condition == WaterCondition::seepage_face || condition == WaterCondition::no_flow) return {{0.0}, {0.0}};
  const TimeTable& rows = choose();
  if (series == SeriesShape::linear) return rows;
  TimeTable jumps;
  for (std::size_t i = 0; i < rows.time.size(); ++i) {
    if (i > 0) {
      jumps.time.push_back(rows.time[i]);
      jumps.value.push_back(rows.value[i - 1]);
    }
    jumps.time.push_back(rows.time[i]);
    jumps.value.push_back(rows.value[i]);
  }
  return jumps;
}

double Material::constrained_modulus() const {
  return young_modulus * (1 - poisson_ratio) / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
}

bool uses(const Case& data, Method method) {
  return std::find(data.methods.begin(), data.methods.end(), method) != data.methods.end();
}

}  // namespace talus::input
