// SPDX-License-Identifier: MIT
#include "run/mpm/record/point_results.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/quality.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/solver/step.hpp"
#include "run/mpm/record/water_record.hpp"

namespace talus::run {

namespace {

/// Largest number of points outside the grid that are listed by number.
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
  if (!body.bars.empty()) result.support_work = work.supports;
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

namespace {

results::SurfaceCondition find_condition(mpm::SurfaceKind kind) {
  switch (kind) {
    case mpm::SurfaceKind::open:
      return results::SurfaceCondition::open;
    case mpm::SurfaceKind::seepage:
      return results::SurfaceCondition::seepage_face;
    case mpm::SurfaceKind::rain:
      return results::SurfaceCondition::rain;
    case mpm::SurfaceKind::flux:
      return results::SurfaceCondition::flux;
    case mpm::SurfaceKind::head:
      return results::SurfaceCondition::total_head;
    case mpm::SurfaceKind::pressure:
      break;
  }
  return results::SurfaceCondition::pressure;
}

}  // namespace

template <int D>
results::WaterBudget make_water_result(const input::Case& data, const mpm::Body<D>& body, double initial) {
  const mpm::Water<D>& water = body.water;
  const std::vector<std::string> names = name_surfaces(water.surfaces);
  results::WaterBudget result;
  result.density = data.water.density;
  result.initial = initial;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const mpm::SurfaceBudget& b = water.budgets[i];
    result.entered += b.entered;
    result.left += b.left;
    result.runoff += b.runoff;
    result.surfaces.push_back(
        {names[i], find_condition(water.surfaces[i].kind), b.entered, b.left, b.supplied, b.runoff});
  }
  const mpm::WaterState<D> state = mpm::find_water_state(body);
  result.stored = state.mass;
  result.lost_between = water.lost_between;
  result.left_grid = water.left_grid;
  result.pressed_in = water.pressed_in;
  const double unexplained = result.stored - (initial + result.entered + water.pressed_in - result.left -
                                              water.transpired - water.lost_between - water.left_grid);
  result.error = unexplained / std::max({initial, result.stored, 1e-300});
  result.largest_pressure = state.largest_pressure;
  result.largest_suction = state.largest_suction;
  result.largest_suction_at.assign(state.place.begin(), state.place.end());
  if (!water.uptakes.empty()) result.transpired = water.transpired;
  return result;
}

template results::WaterBudget make_water_result<2>(const input::Case&, const mpm::Body<2>&, double);
template results::WaterBudget make_water_result<3>(const input::Case&, const mpm::Body<3>&, double);

}  // namespace talus::run
