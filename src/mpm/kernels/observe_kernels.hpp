// SPDX-License-Identifier: MIT
#pragma once
// Kernels that read points, for a body B here or on a GPU.

#include "mesh/mesh.hpp"
#include "mpm/kernels/laws.hpp"
#include "mpm/kernels/observation.hpp"
#include "mpm/kernels/pore_state.hpp"

namespace talus::mpm {

/// Pointer to field 0 of a point; field i is i * B::width after it.
template <class B>
TALUS_PORTABLE const double* find_fields(const B& body, int id) {
  const std::int64_t place = body.points.place[static_cast<std::size_t>(id)];
  return body.points.slot(place / B::width) + place % B::width;
}

template <class B>
TALUS_PORTABLE auto read_xi(const B& /*body*/, const double* fields) {
  constexpr int D = B::dimension;
  Vec<D> xi;
  for (int d = 0; d < D; ++d) xi[d] = fields[(PointFields<D>::xi + d) * B::width];
  return xi;
}

/// Displacement of a point from its reference [m], plus that of the nodes while the geometry was frozen.
template <class B, int D = B::dimension>
TALUS_PORTABLE Vec<D> find_displacement(const B& body, int id, const std::type_identity_t<Vec<D>>& xi) {
  const int e = body.points.element[static_cast<std::size_t>(id)];
  Vec<D> u = mesh::find_place(body.mesh(), e, xi);
  double first = 1;
  for (double x : xi) first -= x;
  for (int d = 0; d < D; ++d) {
    u[d] -= body.points.reference[static_cast<std::size_t>(id)][d];
    for (int k = 0; k <= D; ++k)
      u[d] += (k == 0 ? first : xi[k - 1]) * body.nodes.displacement[body.mesh().elements[e][k]][d];
  }
  return u;
}

/// view_point().
template <class B, int D = B::dimension>
TALUS_PORTABLE PointView<D> look_at_point(const B& body, int id) {
  using P = PointFields<D>;
  constexpr int width = B::width;
  const double* f = find_fields(body, id);
  PointView<D> v;
  v.element = body.points.element[static_cast<std::size_t>(id)];
  v.material = body.points.material[static_cast<std::size_t>(id)];
  const Vec<D> xi = read_xi(body, f);
  v.position = mesh::find_place(body.mesh(), v.element, xi);
  v.displacement = find_displacement(body, id, xi);
  for (int d = 0; d < D; ++d) v.velocity[d] = f[(P::velocity + d) * width];
  const std::size_t block = static_cast<std::size_t>(v.element / width),
                    lane = static_cast<std::size_t>(v.element % width);
  for (std::size_t i = 0; i < P::stress_size; ++i) {
    v.stress[i] = f[(P::stress + i) * width];
    v.strain[i] = body.points.strain_offset[static_cast<std::size_t>(id)][i] +
                  body.elements.strain[(block * P::stress_size + i) * width + lane];
  }
  v.volume = f[P::volume * width];
  v.mass = f[P::mass * width];
  for (int i = 0; i < count_states(body.laws, v.material); ++i)
    v.state[static_cast<std::size_t>(i)] = f[(P::state + i) * width];
  v.plastic_strain = v.state[0];
  if (!body.water.is_wet() || !body.water.laws[v.material].wet) return v;
  using W = WaterFields<D>;
  const double* w = f + body.water.first_field * width;
  const WaterLaw& law = body.water.laws[v.material];
  v.wet = true;
  for (int d = 0; d < D; ++d) v.water_velocity[d] = w[(W::velocity + d) * width];
  v.pressure = w[W::pressure * width];
  v.water_mass = w[W::mass * width];
  v.saturation = material::saturation(law.retention, v.pressure);
  v.porosity = 1 - v.mass / (law.grain_density * v.volume);
  return v;
}

/// Adds a point to the totals of a body.
template <class B, int D = B::dimension>
TALUS_PORTABLE void add_point(const B& body, const PointView<D>& p, const std::type_identity_t<Vec<D>>& gravity,
                              Totals<D>& t) {
  const Vec<D>& water_velocity = body.water.darcy.is_used ? p.velocity : p.water_velocity;
  ++t.points;
  t.mass += p.mass;
  t.water += p.water_mass;
  t.kinetic += 0.5 * (p.mass * dot(p.velocity, p.velocity) + p.water_mass * dot(water_velocity, water_velocity));
  t.potential -= (p.mass + p.water_mass) * dot(gravity, p.position);
  t.elastic +=
      p.volume * find_energy<PointFields<D>::stress_size>(body.laws, p.material, p.stress.data(), p.state.data());
  for (int d = 0; d < D; ++d) {
    t.momentum[d] += p.mass * p.velocity[d] + p.water_mass * water_velocity[d];
    t.centre[d] += p.mass * p.position[d];
  }
}

}  // namespace talus::mpm
