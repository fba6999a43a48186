// SPDX-License-Identifier: MIT
#include "run/mpm/start/drained.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "mpm/body/observe.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/kernels.hpp"
#include "run/mpm/start/stand_in.hpp"

namespace talus::run {
namespace {

/// The load of the pore pressures on the soil, growing with the weight of the stage.
template <int D>
mpm::Load<D> make_pore_load(const mpm::Body<D>& wet, const StagePlan<D>& plan, const StageState& state) {
  mpm::StepOptions<D> options = make_options(plan);
  options.gravity = plan.gravity;
  mpm::Body<D> still = wet;
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

/// Mean saturation of each element, 1 where no soil is wet: laws with suction hardening ask for it.
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

/// One phase, with the mass of the water added to that of the grains.
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
  mpm::Body<D> drained = make_heavy(wet);
  drained.elements.held_saturation = find_saturation(wet);
  drained.conditions.loads.push_back(make_pore_load(wet, plan, state));
  return drained;
}

template <int D>
mpm::CriticalStep find_drained_critical_step(const mpm::Body<D>& wet, const StagePlan<D>& plan) {
  return find_critical_step(make_heavy(wet), plan);
}

template <int D>
results::StageEnd run_drained_stage(mpm::Body<D>& wet, const StagePlan<D>& plan, StageState& state,
                                    const StageHooks<D>& hooks) {
  if (plan.step.geometry != input::Geometry::frozen) {
    throw Error(ExitCode::wrong_input,
                fmt::format("stage '{}' holds the pore pressures, which needs frozen geometry", plan.name));
  }
  mpm::Body<D> drained = make_drained_body(wet, plan, state);
  return run_stand_in(drained, wet, plan, state, hooks);
}

#define TALUS_INSTANTIATE(D)                                                                               \
  template mpm::Body<D> make_drained_body<D>(const mpm::Body<D>&, const StagePlan<D>&, const StageState&); \
  template mpm::CriticalStep find_drained_critical_step<D>(const mpm::Body<D>&, const StagePlan<D>&);      \
  template results::StageEnd run_drained_stage<D>(mpm::Body<D>&, const StagePlan<D>&, StageState&,         \
                                                  const StageHooks<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
