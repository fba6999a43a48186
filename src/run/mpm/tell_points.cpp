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
results::Mesh make_mesh_result(const mpm::Body<D>& body) {
  const mesh::Quality<D> q = mesh::measure_quality(body.mesh());
  results::Mesh result;
  result.dimension = D;
  result.nodes = body.mesh().node_count();
  result.elements = body.mesh().element_count();
  result.soil_elements = q.element_count;
  result.points = body.points.size();
  result.smallest_altitude = q.min_altitude;
  result.mean_altitude = q.mean_altitude;
  result.smallest_altitude_at.assign(q.worst_place.begin(), q.worst_place.end());
  result.mean_size = q.mean_size;
  result.smallest_angle = q.min_angle;
  result.critical_time_step = mpm::find_critical_step(body, mpm::StepOptions<D>{}).dt;
  return result;
}

template <int D>
results::Budgets make_budgets_result(const mpm::Body<D>& body, const Vec<D>& gravity, const mpm::Work& before) {
  const auto t = mpm::sum_points(body, gravity);
  results::Budgets result;
  result.mass = t.mass;
  result.points = t.points;
  result.kinetic_energy = t.kinetic;
  result.potential_energy = t.potential;
  result.elastic_energy = t.elastic;
  const mpm::Work work = body.work - before;
  result.plastic_work = work.dissipated;
  result.damping_work = work.damped;
  result.wall_work = work.walls;
  result.mapping_loss = work.mapping;
  result.external_work = work.external;
  if (body.water.is_wet()) {
    result.drag_work = work.drag;
    result.pore_water_work = work.pore_water;
  }
  result.momentum.assign(t.momentum.begin(), t.momentum.end());
  result.lost.points = body.lost.size();
  result.lost.momentum.assign(D, 0.0);
  for (const auto& l : body.lost) {
    result.lost.mass += l.mass;
    for (std::size_t d = 0; d < D; ++d) result.lost.momentum[d] += l.momentum[d];
    if (result.lost.first.size() < most_named)
      result.lost.first.push_back({l.id, l.time, {l.position.begin(), l.position.begin() + D}});
  }
  return result;
}

results::StepSeconds make_seconds_result(const mpm::Timing& t) {
  return {t.solve_momentum, t.remap_momentum, t.smooth_strain, t.advance_points, t.relocate};
}

template results::Mesh make_mesh_result<2>(const mpm::Body<2>&);
template results::Mesh make_mesh_result<3>(const mpm::Body<3>&);
template results::Budgets make_budgets_result<2>(const mpm::Body<2>&, const Vec<2>&, const mpm::Work&);
template results::Budgets make_budgets_result<3>(const mpm::Body<3>&, const Vec<3>&, const mpm::Work&);

}  // namespace talus::run
