#include "model/case.hpp"

#include <algorithm>

namespace talus::model {

double TimeTable::at(double t) const {
  if (time.empty()) return 1;
  if (t <= time.front()) return value.front();
  if (t >= time.back()) return value.back();
  const auto after = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
  return value[after - 1] + share * (value[after] - value[after - 1]);
}

double Material::constrained_modulus() const {
  return young_modulus * (1 - poisson_ratio) / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
}

}  // namespace talus::model
