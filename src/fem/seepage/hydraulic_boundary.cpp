// SPDX-License-Identifier: MIT
// Values of boundary conditions in time.

#include "fem/seepage/hydraulic_boundary.hpp"

namespace talus::fem {

template <int D>
double HydraulicBoundary<D>::value_at(double time) const {
  if (history.empty()) return value;
  std::size_t next = 0;
  while (next < history.size() && history[next][0] <= time) ++next;
  if (next == 0) return history.front()[1];
  if (next == history.size()) return history.back()[1];
  const auto &a = history[next - 1], &b = history[next];
  return a[1] + (b[1] - a[1]) * (time - a[0]) / (b[0] - a[0]);
}

template struct HydraulicBoundary<2>;
template struct HydraulicBoundary<3>;

}  // namespace talus::fem
