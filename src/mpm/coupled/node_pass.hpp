// SPDX-License-Identifier: MIT
#pragma once
// What the node loops of the coupled step share.

#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/water_surface.hpp"

namespace talus::mpm {

/// What does not change from node to node.
template <int D>
struct NodePass {
  Body<D>& body;
  const StepOptions<D>& options;
  double density;  ///< ρ_w [kg/m³]
  Vec<D> up;       ///< unit, against gravity

  NodePass(Body<D>& b, const StepOptions<D>& o)
      : body(b), options(o), density(b.water.density), up(find_up<D>(o.gravity)) {}
};

}  // namespace talus::mpm
