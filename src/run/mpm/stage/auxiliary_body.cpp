// SPDX-License-Identifier: MIT
#include "run/mpm/stage/auxiliary_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "mpm/solver/observe.hpp"
#include "mpm/solver/step.hpp"
#include "mpm/state/body.hpp"
#include "mpm/two_velocity/kernels.hpp"
#include "mpm/two_velocity/two_velocity_step.hpp"

namespace talus::run {

namespace {

/// Elements with altitudes below this fraction of the median count as small; an ungraded mesh has none.
constexpr double small_altitude = 0.85;

/// Median altitude by volume: one half of the soil is in elements with smaller altitudes [m].
template <int D>
double find_median_altitude(const mpm::Body<D>& body) {
  const mesh::Mesh<D>& mesh = body.mesh();
  std::vector<int> filled;
  double all = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    if (body.points.count[e] == 0) continue;
    filled.push_back(e);
    all += mesh.volumes[e];
  }
  std::sort(filled.begin(), filled.end(), [&](int a, int b) { return mesh.altitudes[a] < mesh.altitudes[b]; });
  double below = 0;
  for (int e : filled) {
    below += mesh.volumes[e];
    if (below >= 0.5 * all) return mesh.altitudes[e];
  }
  return 0;
}

/// Returns the factor on the inertia of the points of each element (T11.4). The critical step depends on the
/// neighbours too.
template <int D>
std::vector<double> find_growth(const mpm::Body<D>& body) {
  const mesh::Mesh<D>& mesh = body.mesh();
  const double wanted = small_altitude * find_median_altitude(body);
  std::vector<double> growth(mesh.elements.size());
  for (int e = 0; e < mesh.element_count(); ++e) {
    double altitude = mesh.altitudes[e];
    for (int n : mesh.neighbours[e])
      if (n >= 0) altitude = std::min(altitude, mesh.altitudes[n]);
    growth[e] = std::max(1.0, (wanted / altitude) * (wanted / altitude));
  }
  return growth;
}

/// Index of field 0 of a point in the data of the points; field i is i * lane_width behind it.
template <int D>
std::size_t find_place(const mpm::Points<D>& points, int id) {
  const std::int64_t place = points.place[id];
  return static_cast<std::size_t>(place / lane_width * points.fields * lane_width + place % lane_width);
}

/// Returns the factor of a load that grows with gravity in the stage.
template <int D>
input::TimeTable find_weight_growth(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state) {
  if (!(plan.gravity_ramp > 0)) return {};
  const double start = state.started ? state.start_time : body.time;
  return {{start, start + plan.gravity_ramp}, {state.gravity_share, 1.0}};
}

}  // namespace

template <int D>
mpm::Body<D> make_even_body(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state) {
  const std::vector<double> growth = find_growth(body);
  mpm::Body<D> even = body;
  std::vector<Vec<D>> relief(body.mesh().nodes.size());
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const int e = body.points.element[id];
    if (growth[e] == 1) continue;
    double* p = &even.points.data[find_place(even.points, id)];
    double& mass = p[mpm::Points<D>::mass * lane_width];
    const double added = mass * (growth[e] - 1);
    mass += added;
    double shape[D + 1];
    shape[0] = 1;
    for (int k = 0; k < D; ++k) {
      shape[k + 1] = p[(mpm::Points<D>::xi + k) * lane_width];
      shape[0] -= shape[k + 1];
    }
    for (int k = 0; k <= D; ++k)
      for (int d = 0; d < D; ++d) relief[body.mesh().elements[e][k]][d] -= shape[k] * added * plan.gravity[d];
  }
  mpm::Load<D> load;
  for (std::size_t i = 0; i < relief.size(); ++i) {
    if (norm(relief[i]) > 0) load.entries.push_back({static_cast<int>(i), relief[i]});
  }
  load.factor = find_weight_growth(body, plan, state);
  if (!load.entries.empty()) even.conditions.loads.push_back(std::move(load));
  return even;
}

template <int D>
void copy_from_auxiliary(const mpm::Body<D>& auxiliary, mpm::Body<D>& body) {
  using P = mpm::Points<D>;
  const bool wet = body.water.is_wet();
  const int fields = wet ? body.water.first_field : body.points.fields;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const std::size_t at = find_place(body.points, id);
    const double* from = &auxiliary.points.data[at];
    double* to = &body.points.data[at];
    for (int i = 0; i < fields; ++i) {
      if (i != P::mass) to[i * lane_width] = from[i * lane_width];
    }
  }
  AlignedVector<double> held_saturation = std::move(body.elements.held_saturation);
  body.elements = auxiliary.elements;
  body.elements.held_saturation = std::move(held_saturation);
  body.nodes = auxiliary.nodes;
  body.bars = auxiliary.bars;
  body.work = auxiliary.work;
  body.monitor = auxiliary.monitor;
  body.timing = auxiliary.timing;
  body.time = auxiliary.time;
  body.step_count = auxiliary.step_count;
  if (!wet) return;
  // The nodal velocities of the wet body are those of the grains; the relative velocity of the water is zero.
  for (int row = 0; row < body.layout->rows; ++row) {
    const double* from = &auxiliary.nodes.motion[static_cast<std::size_t>(row) * mpm::motion_stride<D>];
    double* to = &body.water.motion[static_cast<std::size_t>(row) * mpm::wet_motion_stride<D>];
    for (int d = 0; d < D; ++d) {
      to[d] = to[D + d] = from[d];
      to[2 * D + d] = from[D + d];
      to[3 * D + d] = 0;
    }
  }
}

namespace {

/// Returns the load of the pore pressures on the soil, which grows with gravity in the stage.
template <int D>
mpm::Load<D> make_pore_load(const mpm::Body<D>& wet, const StagePlan<D>& plan, const StageState& state) {
  mpm::StepOptions<D> options = make_options(plan);
  options.gravity = plan.gravity;
  mpm::Body<D> still = wet;
  still.bars.clear();
  still.time = state.started ? state.start_time : wet.time;
  mpm::gather_nodal_sums(still, options);
  const std::vector<Vec<D>> force = mpm::find_pore_force(still, options);
  mpm::Load<D> load;
  for (std::size_t i = 0; i < force.size(); ++i) {
    if (norm(force[i]) > 0) load.entries.push_back({static_cast<int>(i), force[i]});
  }
  load.factor = find_weight_growth(wet, plan, state);
  return load;
}

/// Mean saturation of each element for laws with suction hardening; 1 in dry soil.
template <int D>
AlignedVector<double> find_saturation(const mpm::Body<D>& wet) {
  AlignedVector<double> sum(wet.elements.fill_limit.size(), 0.0), volume(sum.size(), 0.0);
  for (int id = 0; id < wet.points.size(); ++id) {
    if (!mpm::is_present(wet, id)) continue;
    const auto p = mpm::view_point(wet, id);
    sum[p.element] += p.volume * (p.wet ? p.saturation : 1.0);
    volume[p.element] += p.volume;
  }
  for (std::size_t e = 0; e < sum.size(); ++e) sum[e] = volume[e] > 0 ? sum[e] / volume[e] : 1.0;
  return sum;
}

/// Makes a body of one phase, with the mass of grains and water together.
template <int D>
mpm::Body<D> make_heavy(const mpm::Body<D>& wet) {
  mpm::Body<D> heavy = wet;
  heavy.water = {};
  const int water_mass = wet.water.first_field + mpm::WaterFields<D>::mass;
  for (int id = 0; id < wet.points.size(); ++id) {
    if (!mpm::is_present(wet, id) || !wet.water.laws[wet.points.material[id]].wet) continue;
    double* p = &heavy.points.data[find_place(heavy.points, id)];
    p[mpm::Points<D>::mass * lane_width] += p[water_mass * lane_width];
  }
  return heavy;
}

}  // namespace

template <int D>
mpm::Body<D> make_drained_body(const mpm::Body<D>& wet, const StagePlan<D>& plan, const StageState& state) {
  if (plan.step.geometry != input::Geometry::frozen) {
    throw Error(ExitCode::wrong_input,
                fmt::format("stage '{}' holds the pore pressures, which needs frozen geometry", plan.name));
  }
  mpm::Body<D> drained = make_heavy(wet);
  drained.elements.held_saturation = find_saturation(wet);
  drained.conditions.loads.push_back(make_pore_load(wet, plan, state));
  return drained;
}

template <int D>
bool is_drained(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  return body.water.is_wet() && plan.step.water == input::WaterMotion::held;
}

template <int D>
bool equalises_mass(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  return plan.equalises_mass && plan.step.geometry == input::Geometry::frozen && !body.water.is_wet();
}

template <int D>
mpm::CriticalStep find_critical_step(const mpm::Body<D>& body, const StagePlan<D>& plan) {
  if (is_drained(body, plan)) return find_critical_step(make_heavy(body), plan);
  if (equalises_mass(body, plan)) return mpm::find_critical_step(make_even_body(body, plan, {}), make_options(plan));
  return mpm::find_critical_step(body, make_options(plan));
}

#define TALUS_INSTANTIATE(D)                                                                               \
  template mpm::Body<D> make_even_body<D>(const mpm::Body<D>&, const StagePlan<D>&, const StageState&);    \
  template mpm::Body<D> make_drained_body<D>(const mpm::Body<D>&, const StagePlan<D>&, const StageState&); \
  template void copy_from_auxiliary<D>(const mpm::Body<D>&, mpm::Body<D>&);                                \
  template bool is_drained<D>(const mpm::Body<D>&, const StagePlan<D>&);                                   \
  template bool equalises_mass<D>(const mpm::Body<D>&, const StagePlan<D>&);                               \
  template mpm::CriticalStep find_critical_step<D>(const mpm::Body<D>&, const StagePlan<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
