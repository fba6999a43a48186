#include "mpm/step/step.hpp"

#include <chrono>

#include "mpm/coupled/coupled_step.hpp"

namespace talus::mpm {
namespace {

/// Adds the time since the last call, or since its making, to a part of the step.
class Stopwatch {
 public:
  void add_to(double& part) {
    const auto now = std::chrono::steady_clock::now();
    part += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

template <int D>
void step_coupled(Body<D>& body, const StepOptions<D>& options) {
  using input::Smoothing;
  Timing& timing = body.timing;
  Stopwatch watch;
  load_surface(body, options);
  solve_coupled_momentum(body, options);
  watch.add_to(timing.solve_momentum);
  remap_coupled_momentum(body, options);
  watch.add_to(timing.remap_momentum);
  if (options.smoothing != Smoothing::none || options.smooth_pressure) {
    smooth_coupled_increments(body, options);
    watch.add_to(timing.smooth_strain);
  }
  if (options.exchange_water && body.step_count % exchange_interval == 0) {
    exchange_water(body, options);
    watch.add_to(timing.smooth_strain);
  }
  if (!body.water.uptakes.empty() && body.step_count % exchange_interval == 0) {
    draw_root_water(body, options);
    watch.add_to(timing.smooth_strain);
  }
  const MoverLists movers = advance_coupled_points(body, options);
  watch.add_to(timing.advance_points);
  if (options.smoothing == Smoothing::stable) {
    smooth_plastic_return(body, options);
    watch.add_to(timing.smooth_return);
  }
  body.time += options.dt;
  ++body.step_count;
  relocate(body, options, movers);
  gather_loads(body);
  watch.add_to(timing.relocate);
}

template <int D>
void step(Body<D>& body, const StepOptions<D>& options) {
  using input::Smoothing;
  if (body.water.is_wet()) {
    step_coupled(body, options);
    return;
  }
  Timing& timing = body.timing;
  Stopwatch watch;
  solve_momentum(body, options);
  watch.add_to(timing.solve_momentum);
  remap_momentum(body, options);
  watch.add_to(timing.remap_momentum);
  if (options.smoothing != Smoothing::none) {
    smooth_volumetric_strain(body, options);
    watch.add_to(timing.smooth_strain);
  }
  const MoverLists movers = advance_points(body, options);
  watch.add_to(timing.advance_points);
  if (options.smoothing == Smoothing::stable) {
    smooth_plastic_return(body, options);
    watch.add_to(timing.smooth_return);
  }
  body.time += options.dt;
  ++body.step_count;
  relocate(body, options, movers);
  gather_loads(body);
  watch.add_to(timing.relocate);
}

template void step<2>(Body<2>&, const StepOptions<2>&);
template void step<3>(Body<3>&, const StepOptions<3>&);
template void step_coupled<2>(Body<2>&, const StepOptions<2>&);
template void step_coupled<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
