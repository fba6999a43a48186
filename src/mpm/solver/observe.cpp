// SPDX-License-Identifier: MIT
// Read access to single points and sums of a body on the CPU.
#include "mpm/solver/observe.hpp"

#include <algorithm>
#include <cmath>

#include "material/every_law.hpp"
#include "mpm/kernels/observe_kernels.hpp"

namespace talus::mpm {

template <int D>
PointView<D> view_point(const Body<D>& body, int id) {
  return look_at_point(body, id);
}

template <int D>
void reset_displacements(Body<D>& body) {
  for (int id = 0; id < body.points.size(); ++id) {
    if (is_present(body, id))
      body.points.reference[id] =
          mesh::to_global(body.mesh(), body.points.element[id], read_xi(body, find_fields(body, id)));
  }
  std::fill(body.nodes.displacement.begin(), body.nodes.displacement.end(), Vec<D>{});
}

template <int D>
LargestDisplacement find_largest_displacement(const Body<D>& body) {
  LargestDisplacement largest;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!is_present(body, id)) continue;
    const double u = norm(find_displacement(body, id, read_xi(body, find_fields(body, id))));
    if (!(u <= largest.value)) largest = {u, id};
    if (std::isnan(u)) break;  // NaN wins over any number
  }
  return largest;
}

template <int D>
Totals<D> sum_points(const Body<D>& body, const std::type_identity_t<Vec<D>>& gravity) {
  Totals<D> t;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!is_present(body, id)) continue;
    add_point(body, look_at_point(body, id), gravity, t);
  }
  t.find_centre();
  return t;
}

template <int D>
WaterState<D> find_water_state(const Body<D>& body) {
  WaterState<D> state;
  for (int id = 0; id < body.points.size(); ++id)
    if (is_present(body, id)) state.add_point(look_at_point(body, id));
  return state;
}

template <int D>
Observation<D> observe(const Body<D>& body, const std::type_identity_t<Vec<D>>& gravity,
                       const std::vector<int>& points) {
  Observation<D> seen{sum_points(body, gravity), {}, find_largest_displacement(body).value, {}};
  if (body.water.is_wet()) seen.water = find_water_state(body);
  for (const int id : points) seen.points.push_back(is_present(body, id) ? look_at_point(body, id) : PointView<D>());
  return seen;
}

#define TALUS_INSTANTIATE(D)                                                 \
  template PointView<D> view_point<D>(const Body<D>&, int);                  \
  template void reset_displacements<D>(Body<D>&);                            \
  template LargestDisplacement find_largest_displacement<D>(const Body<D>&); \
  template Totals<D> sum_points<D>(const Body<D>&, const Vec<D>&);           \
  template WaterState<D> find_water_state<D>(const Body<D>&);                \
  template Observation<D> observe<D>(const Body<D>&, const Vec<D>&, const std::vector<int>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

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
