// SPDX-License-Identifier: MIT
// Nodal forces of the tractions on sides and on points, at the time of the body.

#include "mpm/step/step.hpp"

namespace talus::mpm {

template <int D>
void gather_loads(Body<D>& body) {
  if (body.conditions.loads.empty()) return;
  body.nodes.load.assign(body.mesh().nodes.size(), Vec<D>{});
  const Points<D>& points = body.points;
  for (const Load<D>& load : body.conditions.loads) {
    const double factor = load.factor.at(body.time);
    for (const auto& entry : load.entries) {
      if (!load.on_points) {
        for (int d = 0; d < D; ++d) body.nodes.load[entry.index][d] += factor * entry.force[d];
        continue;
      }
      const int e = points.element[entry.index];
      if (e < 0) continue;
      const std::int64_t place = points.place[entry.index];
      const double* p = points.slot(place / lane_width) + place % lane_width;
      double shape[D + 1];
      shape[0] = 1;
      for (int k = 0; k < D; ++k) {
        shape[k + 1] = p[(Points<D>::xi + k) * lane_width];
        shape[0] -= shape[k + 1];
      }
      for (int k = 0; k <= D; ++k) {
        Vec<D>& f = body.nodes.load[body.mesh().elements[e][k]];
        for (int d = 0; d < D; ++d) f[d] += factor * shape[k] * entry.force[d];
      }
    }
  }
}

template void gather_loads<2>(Body<2>&);
template void gather_loads<3>(Body<3>&);

}  // namespace talus::mpm
