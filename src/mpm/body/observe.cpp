// SPDX-License-Identifier: MIT
#include "mpm/body/observe.hpp"

#include <algorithm>
#include <cmath>

#include "mpm/coupled/kernels.hpp"
#include "mpm/coupled/pore_state.hpp"

namespace talus::mpm {
namespace {

/// Pointer to field 0 of a point; field i is i * lane_width behind it.
template <int D>
const double* find_fields(const Body<D>& body, int id) {
  const std::int64_t place = body.points.place[id];
  return body.points.slot(place / lane_width) + place % lane_width;
}

template <int D>
std::array<double, D> read_xi(const double* fields) {
  std::array<double, D> xi;
  for (int d = 0; d < D; ++d) xi[d] = fields[(Points<D>::xi + d) * lane_width];
  return xi;
}

/// Displacement of the point from its reference, plus what the nodes moved while the geometry was frozen.
template <int D>
Vec<D> find_displacement(const Body<D>& body, int id, const std::array<double, D>& xi) {
  const int e = body.points.element[id];
  Vec<D> u = mesh::to_global(body.mesh(), e, xi);
  double first = 1;
  for (double x : xi) first -= x;
  for (int d = 0; d < D; ++d) {
    u[d] -= body.points.reference[id][d];
    for (int k = 0; k <= D; ++k)
      u[d] += (k == 0 ? first : xi[k - 1]) * body.nodes.displacement[body.mesh().elements[e][k]][d];
  }
  return u;
}

}  // namespace

template <int D>
PointView<D> view_point(const Body<D>& body, int id) {
  using P = Points<D>;
  const double* f = find_fields(body, id);
  PointView<D> v;
  v.element = body.points.element[id];
  v.material = body.points.material[id];
  const auto xi = read_xi<D>(f);
  v.position = mesh::to_global(body.mesh(), v.element, xi);
  v.displacement = find_displacement<D>(body, id, xi);
  for (int d = 0; d < D; ++d) v.velocity[d] = f[(P::velocity + d) * lane_width];
  const std::size_t block = static_cast<std::size_t>(v.element / lane_width),
                    lane = static_cast<std::size_t>(v.element % lane_width);
  for (std::size_t i = 0; i < P::stress_size; ++i) {
    v.stress[i] = f[(P::stress + i) * lane_width];
    v.strain[i] =
        body.points.strain_offset[id][i] + body.elements.strain[(block * P::stress_size + i) * lane_width + lane];
  }
  v.volume = f[P::volume * lane_width];
  v.mass = f[P::mass * lane_width];
  const bool wet = body.water.is_wet();
  const material::Law& law_of_point = body.laws[v.material];
  for (int i = 0; i < material::state_size(law_of_point); ++i)
    v.state[static_cast<std::size_t>(i)] = f[(P::state + i) * lane_width];
  v.plastic_strain = v.state[0];
  if (!wet || !body.water.laws[v.material].wet) return v;
  using W = WaterFields<D>;
  const double* w = f + body.water.first_field * lane_width;
  const WaterLaw& law = body.water.laws[v.material];
  v.wet = true;
  for (int d = 0; d < D; ++d) v.water_velocity[d] = w[(W::velocity + d) * lane_width];
  v.pressure = w[W::pressure * lane_width];
  v.water_mass = w[W::mass * lane_width];
  v.saturation = material::saturation(law.retention, v.pressure);
  v.porosity = 1 - v.mass / (law.grain_density * v.volume);
  return v;
}

template <int D>
void reset_displacements(Body<D>& body) {
  for (int id = 0; id < body.points.size(); ++id) {
    if (is_present(body, id))
      body.points.reference[id] =
          mesh::to_global(body.mesh(), body.points.element[id], read_xi<D>(find_fields(body, id)));
  }
  std::fill(body.nodes.displacement.begin(), body.nodes.displacement.end(), Vec<D>{});
}

template <int D>
LargestDisplacement find_largest_displacement(const Body<D>& body) {
  LargestDisplacement largest;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!is_present(body, id)) continue;
    const double u = norm(find_displacement<D>(body, id, read_xi<D>(find_fields(body, id))));
    if (!(u <= largest.value)) largest = {u, id};
  }
  return largest;
}

template <int D>
Totals<D> sum_points(const Body<D>& body, const std::type_identity_t<Vec<D>>& gravity) {
  Totals<D> t;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!is_present(body, id)) continue;
    const PointView<D> p = view_point(body, id);
    const Vec<D>& water_velocity = body.water.mixture.is_used ? p.velocity : p.water_velocity;
    ++t.points;
    t.mass += p.mass;
    t.water += p.water_mass;
    t.kinetic += 0.5 * (p.mass * dot(p.velocity, p.velocity) + p.water_mass * dot(water_velocity, water_velocity));
    t.potential -= (p.mass + p.water_mass) * dot(gravity, p.position);
    t.elastic += p.volume * material::elastic_energy<Points<D>::stress_size>(body.laws[p.material], p.stress.data(),
                                                                             p.state.data());
    for (int d = 0; d < D; ++d) {
      t.momentum[d] += p.mass * p.velocity[d] + p.water_mass * water_velocity[d];
      t.centre[d] += p.mass * p.position[d];
    }
  }
  if (t.mass > 0) {
    for (double& c : t.centre) c /= t.mass;
  }
  return t;
}

#define TALUS_INSTANTIATE(D)                                                 \
  template PointView<D> view_point<D>(const Body<D>&, int);                  \
  template void reset_displacements<D>(Body<D>&);                            \
  template LargestDisplacement find_largest_displacement<D>(const Body<D>&); \
  template Totals<D> sum_points<D>(const Body<D>&, const Vec<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
