// SPDX-License-Identifier: MIT
#include "mpm/body/point_state.hpp"

namespace talus::mpm {

template <int D>
void write_state(Body<D>& body, int id, const double* state) {
  const std::int64_t place = body.points.place[id];
  double* fields = body.points.slot(place / lane_width) + place % lane_width;
  const int count = material::state_size(body.laws[body.points.material[id]]);
  for (int i = 0; i < count; ++i) fields[(Points<D>::state + i) * lane_width] = state[i];
}

template void write_state<2>(Body<2>&, int, const double*);
template void write_state<3>(Body<3>&, int, const double*);

}  // namespace talus::mpm
