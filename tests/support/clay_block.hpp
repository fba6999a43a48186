// SPDX-License-Identifier: MIT
#pragma once
// A block of soil, as of overconsolidated clay, that is compressed until it softens in a shear band.

#include <cmath>

#include "mpm/kernels/softening.hpp"
#include "mpm/solver/step.hpp"
#include "mpm/state/body.hpp"
#include "support/soil_body.hpp"

namespace talus::support {

inline constexpr double block_width = 1, block_height = 2, cell_pressure = 50e3,
                        squeezing = 0.02;  ///< [m], [Pa], [1/s]

inline material::ModifiedCamClay make_block_clay() {
  return material::ModifiedCamClay(
      {.compression = 0.15, .swelling = 0.03, .poisson_ratio = 0.3, .critical_state_slope = 1.0});
}

/// `cells` squares wide, under an all-round pressure. `set_state(point, is_soft)` sets the state of a point, which may
/// be in a softer spot at the side. The upper end comes down with `squeezing`. `length`: 0 for none [m].
template <int D>
mpm::Body<D> make_block(int cells, double length, const material::Law& law, auto&& set_state) {
  std::array<int, D> counts;
  Vec<D> size;
  counts[0] = cells, size[0] = block_width;
  counts[1] = 2 * cells, size[1] = block_height;
  if constexpr (D == 3) counts[2] = cells / 2, size[2] = block_width / 2;
  mpm::Body<D> body = fill_body<D>(
      make_mesh<D>(counts, size), {{law, 1800}}, D == 2 ? 3 : 4, [](const Vec<D>&) { return 0; },
      [&](mpm::InitialPoint<D>& p, const Vec<D>& x) {
        for (std::size_t i = 0; i < 3; ++i) p.stress[i] = -cell_pressure;
        set_state(p, std::hypot(x[0], x[1] - 0.7) < 0.25);
      });
  fix_nodes<D>(body, 1, [](const Vec<D>& x) { return x[1] < 1e-9; });
  fix_nodes<D>(body, 0, [](const Vec<D>& x) { return std::hypot(x[0], x[1]) < 1e-9; });
  if constexpr (D == 3) fix_nodes<3>(body, 2, [](const Vec<3>&) { return true; });
  Vec<D> plate{};
  plate[1] = -squeezing * block_height;
  mpm::Load<D> load;
  const auto& nodes = body.mesh().nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool at_end = nodes[i][1] < 1e-9 || nodes[i][1] > block_height - 1e-9;
    if (nodes[i][1] > block_height - 1e-9) move_node<D>(body, i, plate);
    double force = cell_pressure * block_height / (2 * cells) * (at_end ? 0.5 : 1);
    if constexpr (D == 3) {
      const bool at_face = nodes[i][2] < 1e-9 || nodes[i][2] > size[2] - 1e-9;
      force *= size[2] / counts[2] * (at_face ? 0.5 : 1);
    }
    Vec<D> inward{};
    if (nodes[i][0] < 1e-9) inward[0] = force;
    if (nodes[i][0] > block_width - 1e-9) inward[0] = -force;
    if (inward[0] != 0) load.entries.push_back({static_cast<int>(i), inward});
  }
  body.conditions.loads.push_back(load);
  if (length > 0) mpm::set_softening_length(body, length);
  return body;
}

/// Makes the block of clay that bore six times the cell pressure, except in the softer spot.
template <int D>
mpm::Body<D> make_clay_block(int cells, double length) {
  const material::ModifiedCamClay clay = make_block_clay();
  return make_block<D>(cells, length, clay, [&](mpm::InitialPoint<D>& p, bool is_soft) {
    clay.set_initial_state(p.stress.data(), 0.8, 0, (is_soft ? 0.9 : 1) * 6 * cell_pressure, 1, p.state.data());
  });
}

/// Frozen geometry, near rest.
template <int D>
mpm::StepOptions<D> make_block_options(mpm::Body<D>& body) {
  mpm::StepOptions<D> o;
  o.mixed = true, o.moving = false, o.smoothing = input::Smoothing::stable, o.damping = 0.3;
  o.dt = 0.7 * mpm::find_critical_step(body, 1).dt;
  mpm::gather_nodal_sums(body, o);
  mpm::gather_loads(body);
  return o;
}

}  // namespace talus::support
