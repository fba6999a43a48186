// SPDX-License-Identifier: MIT
#include "run/mpm/start/stand_in.hpp"

#include <utility>

#include "mpm/body/observe.hpp"
#include "mpm/coupled/kernels.hpp"

namespace talus::run {

template <int D>
input::TimeTable find_weight_growth(const mpm::Body<D>& body, const StagePlan<D>& plan, const StageState& state) {
  if (!(plan.gravity_ramp > 0)) return {};
  const double start = state.started ? state.start_time : body.time;
  return {{start, start + plan.gravity_ramp}, {state.gravity_share, 1.0}};
}

template <int D>
void copy_from_stand_in(const mpm::Body<D>& stand_in, mpm::Body<D>& body) {
  using P = mpm::Points<D>;
  const bool wet = body.water.is_wet();
  const int fields = wet ? body.water.first_field : body.points.fields;
  for (int id = 0; id < body.points.size(); ++id) {
    if (!mpm::is_present(body, id)) continue;
    const std::size_t at = find_place(body.points, id);
    const double* from = &stand_in.points.data[at];
    double* to = &body.points.data[at];
    for (int i = 0; i < fields; ++i) {
      if (i != P::mass) to[i * lane_width] = from[i * lane_width];
    }
  }
  AlignedVector<double> held_saturation = std::move(body.elements.held_saturation);
  body.elements = stand_in.elements;
  body.elements.held_saturation = std::move(held_saturation);
  body.nodes = stand_in.nodes;
  body.work = stand_in.work;
  body.monitor = stand_in.monitor;
  body.timing = stand_in.timing;
  body.time = stand_in.time;
  body.step_count = stand_in.step_count;
  if (!wet) return;
  // For readers of the nodes: the grains move, no water moves against them.
  for (int row = 0; row < body.layout->rows; ++row) {
    const double* from = &stand_in.nodes.motion[static_cast<std::size_t>(row) * mpm::motion_stride<D>];
    double* to = &body.water.motion[static_cast<std::size_t>(row) * mpm::wet_motion_stride<D>];
    for (int d = 0; d < D; ++d) {
      to[d] = to[D + d] = from[d];
      to[2 * D + d] = from[D + d];
      to[3 * D + d] = 0;
    }
  }
}

template <int D>
results::StageEnd run_stand_in(mpm::Body<D>& stand_in, mpm::Body<D>& body, const StagePlan<D>& plan, StageState& state,
                               const StageHooks<D>& hooks) {
  StageHooks<D> inner;
  if (hooks.output) {
    inner.output = [&](Pause<D>& now, StageState& s) {
      copy_from_stand_in(now.whole(), body);
      PauseHere<D> here(body);
      hooks.output(here, s);
    };
  }
  if (hooks.look) {
    inner.look = [&](const mpm::Body<D>& b, const StageState& s) {
      copy_from_stand_in(b, body);
      hooks.look(body, s);
    };
  }
  inner.look_is_due = hooks.look_is_due;
  inner.report = hooks.report;
  inner.report_is_due = hooks.report_is_due;
  if (hooks.save_last_good) {
    inner.save_last_good = [&](const mpm::Body<D>& b, const StageState& s) {
      copy_from_stand_in(b, body);
      return hooks.save_last_good(body, s);
    };
  }
  if (hooks.mark) {
    inner.mark = [&]() -> GoBack<D> {
      return [&body, go_back = hooks.mark()](const mpm::Body<D>& b, const StageState& s, const StagePlan<D>& p) {
        copy_from_stand_in(b, body);
        go_back(body, s, p);
      };
    };
  }
  const results::StageEnd end = run_stage(stand_in, plan, state, inner);
  copy_from_stand_in(stand_in, body);
  body.nodes.load.clear();  // some are the stand-in's alone
  mpm::gather_loads(body);
  return end;
}

#define TALUS_INSTANTIATE(D)                                                                                    \
  template input::TimeTable find_weight_growth<D>(const mpm::Body<D>&, const StagePlan<D>&, const StageState&); \
  template void copy_from_stand_in<D>(const mpm::Body<D>&, mpm::Body<D>&);                                      \
  template results::StageEnd run_stand_in<D>(mpm::Body<D>&, mpm::Body<D>&, const StagePlan<D>&, StageState&,    \
                                             const StageHooks<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::run
