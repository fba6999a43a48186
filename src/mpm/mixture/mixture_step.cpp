// SPDX-License-Identifier: MIT
#include "mpm/mixture/mixture_step.hpp"

#include "mpm/coupled/coupled_step.hpp"
#include "mpm/step/stopwatch.hpp"

namespace talus::mpm {

template <int D>
void step_darcy(Body<D>& body, const StepOptions<D>& o) {
  Stopwatch timed;
  Timing& t = body.timing;
  MoverLists movers;
  timed(t.solve_momentum, [&] {
    find_contents(body, o);
    load_surface(body, o);
    find_flow(body, o);
    load_darcy(body, o);
    press_nodes(body, o);
    const Work before = body.work;
    solve_momentum(Dry{}, body, o);
    body.work = before;  // counted with the pressures of the end of the step
    predict_motion(body, o);
    solve_pressures(body, o);
    press_nodes(body, o);
    solve_momentum(Dry{}, body, o);
    body.work.pore_water -= 0.5 * body.nodes.motion_step * find_pore_power(body, o);  // as mapping counts its forces
  });
  timed(t.remap_momentum, [&] {
    remap_momentum(Dry{}, body, o);
    body.work.pore_water -= 0.5 * o.dt * find_pore_power(body, o);
  });
  if (o.smoothing != input::Smoothing::none) timed(t.smooth_strain, [&] { smooth_increments(Dry{}, body, o); });
  timed(t.advance_points, [&] { movers = advance_points(Darcy{}, body, o); });
  body.time += o.dt;
  ++body.step_count;
  timed(t.relocate, [&] { relocate(body, o, movers); });
}

template void step_darcy<2>(Body<2>&, const StepOptions<2>&);
template void step_darcy<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
