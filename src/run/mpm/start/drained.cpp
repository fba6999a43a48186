// SPDX-License-Identifier: MIT
#include "run/mpm/start/drained.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "mpm/body/observe.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/kernels.hpp"

namespace talus::run {
namespace {

/// Place of field 0 of a point in the points' data; field i is i * lane_width behind it.
template <int D>
std::size_t find_place(const mpm::Points<D>& points, int id) {
  const std::int64_t place = points.place[id];
  return static_cast<std::size_t>(place / lane_width * points.fields * lane_width + place % lane_width);
}

/// The load of the pore pressures on the soil, growing with the weight of the stage.
template <int D>
mpm::Load<D> make_pore_load(const mpm::Body<D>& wet, const StagePlan<D>& plan, const StageState& state) {
  mpm::StepOptions<D> options = make_options(plan);
  options.gravity = plan.gravity;
  mpm::Body<D> still = wet;
  const double start = still.time = state.started ? state.start_time : wet.time;
  mpm::gather_nodal_sums(still, options);
  const std::vector<Vec<D>> force = mpm::find_pore_force(still, options);
  mpm::Load<D> load;
  for (std::size_t i = 0; i < force.size(); ++i) {
    if (norm(force[i]) > 0) load.entries.push_back({static_cast<int>(i), force[i]});
  }
  if (plan.gravity_ramp > 0) load.factor = {{start, start + plan.gravity_ramp}, {state.gravity_share, 1.0}};
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
mpm::CriticalStep find_drained_critical_step(const mpm::Body<D>& wet, double mass_scaling) {
  return mpm::find_critical_step(make_heavy(wet), mass_scaling);
}

template <int D>
void copy_from_drained(const mpm::Body<D>& drained, mpm::Body<D>& wet) {
  using P = mpm::Points<D>;
  for (int id = 0; id < wet.points.size(); ++id) {
    if (!mpm::is_present(wet, id)) continue;
    const std::size_t at = find_place(wet.points, id);
    const double* from = &drained.points.data[at];
    double* to = &wet.points.data[at];
    for (int i = 0; i < wet.water.first_field; ++i) {
      if (i != P::mass) to[i * lane_width] = from[i * lane_width];
    }
  }
  wet.elements = drained.elements;
  wet.elements.held_saturation.clear();
  wet.nodes = drained.nodes;
  // For readers of the nodes: the grains move, no water moves against them.
  for (int row = 0; row < wet.layout->rows; ++row) {
    const double* from = &drained.nodes.motion[static_cast<std::size_t>(row) * mpm::motion_stride<D>];
    double* to = &wet.water.motion[static_cast<std::size_t>(row) * mpm::wet_motion_stride<D>];
    for (int d = 0; d < D; ++d) {
      to[d] = to[D + d] = from[d];
      to[2 * D + d] = from[D + d];
      to[3 * D + d] = 0;
    }
  }
  wet.work = drained.work;
  wet.monitor = drained.monitor;
  wet.timing = drained.timing;
  wet.time = drained.time;
  wet.step_count = drained.step_count;
}

template <int D>
results::StageEnd run_drained_stage(mpm::Body<D>& wet, const StagePlan<D>& plan, StageState& state,
                                    const StageHooks<D>& hooks) {
  if (plan.step.geometry != input::Geometry::frozen) {
    throw Error(ExitCode::wrong_input,
                fmt::format("stage '{}' holds the pore pressures, which needs frozen geometry", plan.name));
  }
  mpm::Body<D> drained = make_drained_body(wet, plan, state);
  StageHooks<D> inner;
  if (hooks.output) {
    inner.output = [&](const mpm::Body<D>& b, StageState& s) {
      copy_from_drained(b, wet);
      hooks.output(wet, s);
    };
  }
  if (hooks.look) {
    inner.look = [&](const mpm::Body<D>& b, const StageState& s) {
      copy_from_drained(b, wet);
      hooks.look(wet, s);
    };
  }
  if (hooks.save_last_good) {
    inner.save_last_good = [&](const mpm::Body<D>& b, const StageState& s) {
      copy_from_drained(b, wet);
      return hooks.save_last_good(wet, s);
    };
  }
  if (hooks.mark) {
    inner.mark = [&]() -> GoBack<D> {
      return [&wet, go_back = hooks.mark()](const mpm::Body<D>& b, const StageState& s, const StagePlan<D>& p) {
        copy_from_drained(b, wet);
        go_back(wet, s, p);
      };
    };
  }
  const results::StageEnd end = run_stage(drained, plan, state, inner);
  copy_from_drained(drained, wet);
  if (wet.conditions.loads.empty()) wet.nodes.load.clear();  // that of the pressures; they act by themselves again
  return end;
}

#define TALUS_INSTANTIATE(D)                                                                               \
  template mpm::Body<D> make_drained_body<D>(const mpm::Body<D>&, const StagePlan<D>&, const StageState&); \
  template mpm::CriticalStep find_drained_critical_step<D>(const mpm::Body<D>&, double);                   \
  template void copy_from_drained<D>(const mpm::Body<D>&, mpm::Body<D>&);                                  \
  template results::StageEnd run_drained_stage<D>(mpm::Body<D>&, const StagePlan<D>&, StageState&,         \
                                                  const StageHooks<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
