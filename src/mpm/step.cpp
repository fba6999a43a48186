#include "mpm/step.hpp"

namespace talus::mpm {

template <int D>
void step(Body<D>& body, const StepOptions<D>& options) {
  using model::Smoothing;
  solve_momentum(body, options);
  remap_momentum(body, options);
  if (options.smoothing != Smoothing::none) smooth_volumetric_strain(body, options);
  const MoverLists movers = advance_points(body, options);
  if (options.smoothing == Smoothing::stable) smooth_plastic_return(body, options);
  body.time += options.dt;
  ++body.step_count;
  relocate(body, options, movers);
  gather_loads(body);
}

template void step<2>(Body<2>&, const StepOptions<2>&);
template void step<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
