// SPDX-License-Identifier: MIT
#pragma once
// Accelerations of free nodes (without constraint, load or surface condition), which are most nodes of a body, one pack
// of nodes at once (T14.6).

#include "base/rows.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/node_rows.hpp"
#include "mpm/two_velocity/kernels.hpp"

namespace talus::mpm {

/// The pack of nodes that starts at `first`.
template <int D>
struct NodePack {
  int rows[lane_width];  ///< the first row of each node
  unsigned special = 0;  ///< bit set of the nodes with a constraint, on the surface, or in several chunks
  Mask free{true};       ///< the others

  NodePack(const Body<D>& body, int first) {
    const Layout<D>& layout = *body.layout;
    for (int l = 0; l < lane_width; ++l) {
      const int i = first + l, start = layout.row_start[i];
      const Vec<D>& facing = body.water.facing[i];
      rows[l] = layout.node_rows[start];
      if (layout.row_start[i + 1] - start == 1 && body.water.axes_of_node[i] < 0 && dot(facing, facing) == 0) continue;
      special |= 1u << l;
      set_lane(free, l, false);
    }
  }
  bool has_free() const { return special != (1u << lane_width) - 1; }
};

/// Work of packs of nodes, by lane [J].
struct PackWork {
  Pack damped{0.0}, drag{0.0}, mapping{0.0};

  void add_to(PieceSums& sums) const {
    for (int l = 0; l < lane_width; ++l) {
      sums.damped += damped[l];
      sums.drag += drag[l];
      sums.mapping += mapping[l];
    }
  }
};

/// -α sign(velocity)|unbalanced|, component by component (2.89).
TALUS_KERNEL Pack find_damping(Pack unbalanced, Pack velocity, double alpha) {
  const Pack force = lane_abs(unbalanced) * alpha;
  return select(velocity > Pack(0.0), -force, select(velocity < Pack(0.0), force, Pack(0.0)));
}

/// Writes the accelerations of the whole pack. Those of its special nodes are meaningless here, and their work is not
/// counted. The velocities in the same rows are written by the remap. `density`: ρ_w [kg/m³].
template <int D>
void solve_free_nodes(Body<D>& body, const StepOptions<D>& o, double density, const NodePack<D>& nodes,
                      PackWork& work) {
  using C = WetColumns<D>;
  const double beta = o.mass_scaling;
  const Pack zero(0.0), one(1.0);
  Pack t[wet_sums_stride<D>], last[4 * D];
  load_rows<C::count, wet_sums_stride<D>>(body.water.sums.data(), nodes.rows, t);
  load_rows<4 * D, wet_motion_stride<D>>(body.water.motion.data(), nodes.rows, last);
  const Pack grains = t[C::mass], water = t[C::water_mass];
  const Mask some = grains > Pack(1e-12 * body.smallest_mass), wet = some && water > zero;
  const Pack whole = select(wet, t[C::volume] * density, zero);
  const Pack per_grains = 1.0 / select(some, grains, one), per_water = 1.0 / select(wet, water, one);
  const Pack content = select(wet, water / select(wet, whole, one), zero),
             drag = content * t[C::resistance] * t[C::volume] / select(wet, t[C::relative], one);
  const Pack solid = grains * beta, fluid = whole * beta, implicit = o.implicit_drag ? o.dt * drag : zero;
  const Pack inverse = 1.0 / select(wet, solid * fluid + implicit * (solid + content * fluid), one);
  const Pack ss = select(wet, (fluid + implicit) * inverse, per_grains * (1 / beta)), sw = content * implicit * inverse;
  const Pack ww = select(wet, (solid + content * implicit) * inverse, zero), ws = select(wet, implicit * inverse, zero);
  Pack damped(0.0), rubbed(0.0), lost(0.0);
  Pack out[8];  // the rest of the row is kept: special nodes in the pack still need their velocities
  TALUS_UNROLL
  for (int c = 0; c < 8; ++c) out[c] = last[c];
  TALUS_UNROLL
  for (int d = 0; d < D; ++d) {
    const Pack v = t[C::momentum + d] * per_grains, w = select(wet, t[C::water_momentum + d] * per_water, zero);
    const Pack external = (grains + water) * o.gravity[d], pull = drag * (w - v);
    const Pack on_water = t[C::water_force + d] + whole * o.gravity[d];
    const Pack on_grains = t[C::force + d] + external - content * on_water;
    const Pack f_w = on_water - pull, f_s = on_grains + content * pull;
    Pack left_w = on_water, left_s = on_grains;
    if (o.net_damping) {  // (T14.10)
      left_w = fluid * (ww * f_w + ws * f_s);
      left_s = solid * (ss * f_s + sw * f_w);
    }
    const Pack damp_w = find_damping(left_w, w, o.water_damping), damp_s = find_damping(left_s, v, o.damping);
    const Pack a_w = ww * (f_w + damp_w) + ws * (f_s + damp_s), a_s = ss * (f_s + damp_s) + sw * (f_w + damp_w);
    const Pack relative = w - v + (o.implicit_drag ? o.dt : 0.0) * (a_w - a_s);
    damped -= damp_s * (v + 0.5 * o.dt * a_s) + content * damp_w * (w + 0.5 * o.dt * a_w);
    rubbed += content * drag * relative * relative;
    lost += body.nodes.motion_step * (t[C::force + d] * last[2 * D + d] + t[C::water_force + d] * last[3 * D + d]) -
            o.dt * (a_s * t[C::momentum + d] + select(wet, a_w * t[C::water_momentum + d], zero));
    out[d] = select(some, a_s, zero);
    out[D + d] = select(wet, a_w, zero);
  }
  const Mask mine = some && nodes.free;
  work.damped += select(mine, o.dt * damped, zero);
  work.drag += select(mine, o.dt * rubbed, zero);
  work.mapping += select(mine, 0.5 * lost - o.dt * (damped + rubbed), zero);
  store_rows<8, wet_motion_stride<D>>(body.water.motion.data(), nodes.rows, out);
}

}  // namespace talus::mpm
