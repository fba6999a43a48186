// SPDX-License-Identifier: MIT
// A frictionless wall conserves energy. Regression test: in the remap of MUSL a node stopped by a wall could receive a
// velocity away from it, which strained the soil without work and doubled the energy of a bounce.

#include <gtest/gtest.h>

#include "mpm/solver/step.hpp"
#include "support/soil_body.hpp"

namespace talus {

TEST(EngineWalls, ElasticColumnBouncesWithItsEnergy) {
  for (const int points : {1, 3, 12}) {
    const double v0 = 0.2, gap = 0.1, height = 0.6, young = 1e7, density = 1800;
    mpm::Body<2> body = support::fill_body<2>(
        support::make_mesh<2>({20, 10}, {2, 1}, 0), {{material::LinearElastic::from_young(young, 0), density}}, points,
        [&](const Vec<2>& x) { return x[1] > gap && x[1] < gap + height ? 0 : -1; },
        [&](mpm::InitialPoint<2>& p, const Vec<2>&) { p.velocity[1] = -v0; });
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i) {
      if (body.mesh().nodes[i][1] > 1e-9) continue;
      auto& c = support::get_constraint(body, i);
      c.has_wall = true;
      c.wall_normal = {0, -1};
    }
    support::fix_nodes<2>(body, 0, [](const Vec<2>& x) { return x[0] < 1e-9 || x[0] > 2 - 1e-9; });
    mpm::StepOptions<2> o;
    o.dt = 0.2 * mpm::find_critical_step(body, 1).dt;
    mpm::gather_nodal_sums(body, o);
    const double before = mpm::sum_points(body, {}).kinetic;
    while (body.time < gap / v0 + 2.5 * height / std::sqrt(young / density)) mpm::step(body, o);
    const auto after = mpm::sum_points(body, {});
    EXPECT_NEAR((after.kinetic + after.elastic) / before, 1, 0.03) << points << " points per element";
  }
}

}  // namespace talus
