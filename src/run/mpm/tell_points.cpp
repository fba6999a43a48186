// SPDX-License-Identifier: MIT
#include "run/mpm/tell_points.hpp"

#include "mesh/quality.hpp"
#include "mpm/body/observe.hpp"
#include "mpm/step/critical_step.hpp"

namespace talus::run {
namespace {

/// Of points that left the grid so many are named.
constexpr std::size_t most_named = 100;

}  // namespace

template <int D>
results::Mesh tell_mesh(const mpm::Body<D>& body) {
  const mesh::Quality<D> q = mesh::measure_quality(body.mesh());
  results::Mesh told;
  told.dimension = D;
  told.nodes = body.mesh().node_count();
  told.elements = body.mesh().element_count();
  told.soil_elements = q.element_count;
  told.points = body.points.size();
  told.smallest_altitude = q.min_altitude;
  told.mean_altitude = q.mean_altitude;
  told.smallest_altitude_at.assign(q.worst_place.begin(), q.worst_place.end());
  told.mean_size = q.mean_size;
  told.smallest_angle = q.min_angle;
  told.critical_time_step = mpm::find_critical_step(body, mpm::StepOptions<D>{}).dt;
  return told;
}

template <int D>
results::Budgets tell_budgets(const mpm::Body<D>& body, const Vec<D>& gravity, const mpm::Work& before) {
  const auto t = mpm::sum_points(body, gravity);
  results::Budgets told;
  told.mass = t.mass;
  told.points = t.points;
  told.kinetic_energy = t.kinetic;
  told.potential_energy = t.potential;
  told.elastic_energy = t.elastic;
  const mpm::Work work = body.work - before;
  told.plastic_work = work.dissipated;
  told.damping_work = work.damped;
  told.wall_work = work.walls;
  told.mapping_loss = work.mapping;
  told.external_work = work.external;
  if (body.water.is_wet()) {
    told.drag_work = work.drag;
    told.pore_water_work = work.pore_water;
  }
  told.momentum.assign(t.momentum.begin(), t.momentum.end());
  told.lost.points = body.lost.size();
  told.lost.momentum.assign(D, 0.0);
  for (const auto& l : body.lost) {
    told.lost.mass += l.mass;
    for (std::size_t d = 0; d < D; ++d) told.lost.momentum[d] += l.momentum[d];
    if (told.lost.first.size() < most_named)
      told.lost.first.push_back({l.id, l.time, {l.position.begin(), l.position.begin() + D}});
  }
  return told;
}

results::StepSeconds tell_seconds(const mpm::Timing& t) {
  return {t.solve_momentum, t.remap_momentum, t.smooth_strain, t.advance_points, t.relocate};
}

template results::Mesh tell_mesh<2>(const mpm::Body<2>&);
template results::Mesh tell_mesh<3>(const mpm::Body<3>&);
template results::Budgets tell_budgets<2>(const mpm::Body<2>&, const Vec<2>&, const mpm::Work&);
template results::Budgets tell_budgets<3>(const mpm::Body<3>&, const Vec<3>&, const mpm::Work&);

}  // namespace talus::run
