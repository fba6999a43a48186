// SPDX-License-Identifier: MIT
#include "mpm/step/step.hpp"

#include "mpm/coupled/coupled_step.hpp"
#include "mpm/mixture/mixture_step.hpp"
#include "mpm/step/stopwatch.hpp"

namespace talus::mpm {
namespace {

/// The lines of the step, each timed as a part of it.
template <class Phase, int D>
void run_lines(Phase phase, Body<D>& body, const StepOptions<D>& o, Stopwatch timed) {
  using input::Smoothing;
  constexpr bool wet = Phase::has_water;
  const bool exchanges = wet && body.step_count % exchange_interval == 0;
  Timing& t = body.timing;
  MoverLists movers;
  if (wet) timed(t.solve_momentum, [&] { load_surface(body, o); });
  timed(t.solve_momentum, [&] { solve_momentum(phase, body, o); });
  timed(t.remap_momentum, [&] { remap_momentum(phase, body, o); });
  if (o.smoothing != Smoothing::none || (wet && o.smooth_pressure))
    timed(t.smooth_strain, [&] { smooth_increments(phase, body, o); });
  if (exchanges && o.exchange_water) timed(t.smooth_strain, [&] { exchange_water(body, o); });
  if (exchanges && !body.water.uptakes.empty()) timed(t.smooth_strain, [&] { draw_root_water(body, o); });
  timed(t.advance_points, [&] { movers = advance_points(phase, body, o); });
  body.time += o.dt;
  ++body.step_count;
  timed(t.relocate, [&] { relocate(body, o, movers); });
  timed(t.relocate, [&] { gather_loads(body); });
}

}  // namespace

template <int D>
void step(Body<D>& body, const StepOptions<D>& options) {
  if (body.water.is_wet() && options.darcy)
    step_darcy(body, options);
  else if (body.water.is_wet())
    run_lines(Wet{}, body, options, {});
  else
    run_lines(Dry{}, body, options, {});
}

template void step<2>(Body<2>&, const StepOptions<2>&);
template void step<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
