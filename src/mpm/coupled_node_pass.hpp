#pragma once
// What the node loops of the coupled step share.

#include "mpm/coupled.hpp"

namespace talus::mpm {

/// What does not change from node to node.
template <int D>
struct NodePass {
  Body<D>& body;
  const StepOptions<D>& options;
  double density = 0;  ///< ρ_w [kg/m³]
  Vec<D> up{};         ///< unit, against gravity

  NodePass(Body<D>& b, const StepOptions<D>& o) : body(b), options(o) {
    for (const WaterLaw& law : b.water.laws) {
      if (law.wet) density = law.density;
    }
    const double g = norm(o.gravity);
    for (int d = 0; d < D && g > 0; ++d) up[d] = -o.gravity[d] / g;
  }
};

}  // namespace talus::mpm
