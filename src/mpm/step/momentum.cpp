// SPDX-License-Identifier: MIT
// The two node loops of the step: accelerations, and MUSL's nodal velocities.

#include <algorithm>
#include <cmath>

#include "mpm/body/node_rows.hpp"
#include "mpm/body/rows.hpp"
#include "mpm/step/kernels.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {
namespace {

// long: its parts, in functions of their own, are contracted to other fused operations: other bits
template <int D>
void solve_nodes(Body<D>& body, const StepOptions<D>& o, int begin, int end, PieceSums& sums) {
  const Layout<D>& layout = *body.layout;
  const double cutoff = 1e-12 * body.smallest_mass;
  const double alpha = o.damping, inverse_scaling = 1 / o.mass_scaling;
  const bool loaded = !body.nodes.load.empty();
  const double last_dt = body.nodes.motion_step;
  double damped = 0, walls = 0, mapping = 0;  // locals: they stay in registers
  const auto& constraint_of = body.conditions.constraint_of_node;
  for (int i = begin; i < end; ++i) {
    const int* rows = &layout.node_rows[static_cast<std::size_t>(layout.row_start[i])];
    const int copies = layout.row_start[i + 1] - layout.row_start[i];
    double t[1 + 2 * D];
    sum_rows<1 + 2 * D, sums_stride>(body.nodes.sums, rows, copies, t);
    const double m_i = t[0];
    Vec<D> a{}, f_damp{}, f_ext{};
    if (m_i > cutoff) {
      const double inverse_mass = 1 / m_i, inverse = inverse_scaling * inverse_mass;
      for (int d = 0; d < D; ++d) {
        f_ext[d] = m_i * o.gravity[d];
        if (loaded) f_ext[d] += body.nodes.load[i][d];
        const double f = t[1 + D + d] + f_ext[d];
        const double p = t[1 + d];
        f_damp[d] = p != 0 ? -std::copysign(alpha * std::abs(f), p) : 0.0;
        a[d] = (f + f_damp[d]) * inverse;
      }
      const int c = constraint_of[i];
      if (c >= 0) {
        const Constraint<D>& constraint = body.conditions.constraints[static_cast<std::size_t>(c)];
        if (constraint.has_wall) {
          // The out-of-balance force that damping is a share of holds the wall's reaction, or a resting block would be
          // shaken by a share of its own weight.
          Vec<D> f, v;
          for (int d = 0; d < D; ++d) {
            f[d] = t[1 + D + d] + f_ext[d];
            v[d] = t[1 + d] * inverse_mass;
          }
          const bool pressed = dot(v, constraint.wall_normal) + o.dt * inverse * dot(f, constraint.wall_normal) > 0;
          body.conditions.pressed[static_cast<std::size_t>(c)] = pressed;
          const Vec<D> left = unsupported_part<D>(constraint, pressed, f);
          Vec<D> wanted;
          for (int d = 0; d < D; ++d) {
            f_damp[d] = v[d] != 0 ? -std::copysign(alpha * std::abs(left[d]), v[d]) : 0.0;
            wanted[d] = v[d] + o.dt * inverse * (f[d] + f_damp[d]);
          }
          const Vec<D> allowed = constrain_velocity(body.conditions, constraint, wanted, body.time + o.dt);
          for (int d = 0; d < D; ++d) a[d] = (allowed[d] - v[d]) / o.dt;
        } else {
          // Along its fixed directions the node moves as what holds it, so what other speed its points bring there is
          // taken from them, and damping takes no share of what supports bear.
          Vec<D> f, v;
          for (int d = 0; d < D; ++d) {
            f[d] = t[1 + D + d] + f_ext[d];
            v[d] = t[1 + d] * inverse_mass;
          }
          const Vec<D> kept = free_part(constraint, v);
          f = free_part(constraint, f);
          for (int d = 0; d < D; ++d) {
            f_damp[d] = v[d] != 0 ? -std::copysign(alpha * std::abs(f[d]), v[d]) : 0.0;
            a[d] = (f[d] + f_damp[d]) * inverse;
          }
          a = free_part(constraint, a);
          for (int d = 0; d < D; ++d) a[d] -= (v[d] - kept[d]) / o.dt;
          if (constraint.factor >= 0) {
            const Vec<D> given = find_drive(body.conditions, constraint, body.time + o.dt);
            for (int d = 0; d < D; ++d) a[d] += given[d] / o.dt;
          }
        }
      }
      // What is lost on the way to the points is added up here and in remap_momentum(), theory 9.
      const double* last = &body.nodes.motion[static_cast<std::size_t>(rows[0]) * motion_stride<D> + D];
      double lost = 0;
      for (int d = 0; d < D; ++d) lost += last_dt * last[d] * t[1 + D + d] - o.dt * a[d] * t[1 + d];
      if (alpha > 0) {
        double braked = 0;
        for (int d = 0; d < D; ++d) braked -= f_damp[d] * (t[1 + d] * inverse_mass + 0.5 * o.dt * a[d]) * o.dt;
        damped += braked;
        lost -= 2 * braked;
      }
      if (c >= 0) {
        double wall = 0;  // friction along the way, and the motion that the wall stops
        for (int d = 0; d < D; ++d) {
          const double change = o.dt * a[d];
          const double held = o.mass_scaling * m_i * a[d] - t[1 + D + d] - f_ext[d] - f_damp[d];
          wall -= held * (t[1 + d] * inverse_mass + 0.5 * change) * o.dt;
        }
        walls += wall;
        lost -= 2 * wall;
      }
      mapping += 0.5 * lost;
      if (o.monitor) {
        Vec<D> f, v;
        for (int d = 0; d < D; ++d) {
          f[d] = t[1 + D + d] + f_ext[d];
          v[d] = t[1 + d] * inverse_mass;
        }
        if (c >= 0) {
          const Constraint<D>& constraint = body.conditions.constraints[static_cast<std::size_t>(c)];
          const bool pressed = constraint.has_wall && body.conditions.pressed[static_cast<std::size_t>(c)];
          f = unsupported_part<D>(constraint, pressed, f);
          f_ext = free_part(constraint, f_ext);
          v = free_part(constraint, v);
        }
        sums.out_of_balance2 += dot(f, f);
        sums.external2 += dot(f_ext, f_ext);
        const double speed2 = dot(v, v);
        sums.kinetic += 0.5 * m_i * speed2;
        // A NaN must win, or an unstable run would look calm.
        if (!(speed2 <= sums.speed2)) {
          sums.speed2 = speed2;
          sums.fastest = i;
        }
      }
    }
    for (int k = 0; k < copies; ++k) {
      double* row = &body.nodes.motion[static_cast<std::size_t>(rows[k]) * motion_stride<D>];
      for (int d = 0; d < D; ++d) row[d] = a[d];
    }
  }
  sums.damped += damped;
  sums.walls += walls;
  sums.mapping += mapping;
}

}  // namespace

template <int D>
void solve_momentum(Dry, Body<D>& body, const StepOptions<D>& o) {
  solve_pieces(body, o.threads, body.nodes.sums, sums_stride, o.monitor,
               [&](int begin, int end, PieceSums& sums) { solve_nodes(body, o, begin, end, sums); });
}

template <int D>
void remap_momentum(Dry, Body<D>& body, const StepOptions<D>& o) {
  const Layout<D>& layout = *body.layout;
  const bool far = body.points.size() > 50000;  // beyond the second-level cache
  for_chunks_and_update(body, o.threads, body.nodes.sums, sums_stride, [&](int c) {
    for (int b = layout.chunk_start[c]; b < layout.chunk_start[c + 1]; ++b) {
      if (body.points.block_used[b] == 0) continue;
      const int* rows = &layout.connectivity[static_cast<std::size_t>(b) * (D + 1) * lane_width];
      const double* moments = &body.elements.moments[static_cast<std::size_t>(b) * moment_size<D> * lane_width];
      if (far && b + 2 < layout.blocks) {
        const int* ahead = rows + 2 * (D + 1) * lane_width;
        for (int i = 0; i < (D + 1) * lane_width; ++i) {
          __builtin_prefetch(&body.nodes.motion[static_cast<std::size_t>(ahead[i]) * motion_stride<D>], 0, 3);
          __builtin_prefetch(&body.nodes.sums[static_cast<std::size_t>(ahead[i]) * sums_stride], 1, 3);
        }
        for (int i = 0; i < moment_size<D>; ++i)
          __builtin_prefetch(moments + (2 * moment_size<D> + i) * lane_width, 0, 3);
      }
      Pack a[D + 1][D], change[D + 1][D], m[moment_size<D>];
      TALUS_UNROLL
      for (int k = 0; k <= D; ++k)
        load_rows<D, motion_stride<D>>(body.nodes.motion.data(), rows + k * lane_width, a[k]);
      TALUS_UNROLL
      for (int q = 0; q < moment_size<D>; ++q) m[q] = load<Pack>(moments + q * lane_width);
      remap_element<D, Pack>(m, a, o.dt, change);
      TALUS_UNROLL
      for (int k = 0; k <= D; ++k) add_rows<D, 1>(body.nodes.sums.data(), rows + k * lane_width, change[k]);
    }
  });
  const double cutoff = 1e-12 * body.smallest_mass;
  const bool loaded = !body.nodes.load.empty();
  std::vector<std::array<double, 2>> works(static_cast<std::size_t>(layout.chunks));  // external, lost in the mapping
  for_node_pieces(body, o.threads, [&](int begin, int end, int c) {
    double work = 0, lost = 0;
    for (int i = begin; i < end; ++i) {
      const int* node_rows = &layout.node_rows[static_cast<std::size_t>(layout.row_start[i])];
      const int copies = layout.row_start[i + 1] - layout.row_start[i];
      double t[1 + 2 * D];
      sum_rows<1 + 2 * D, sums_stride>(body.nodes.sums, node_rows, copies, t);
      Vec<D> v{};
      if (t[0] > cutoff) {
        const double inverse = 1 / t[0];
        for (int d = 0; d < D; ++d) v[d] = t[1 + d] * inverse;
        const int constraint = body.conditions.constraint_of_node[i];
        if (constraint >= 0) {
          v = constrain_remapped(body.conditions, constraint, v, body.time + o.dt);
        }
        const double* a = &body.nodes.motion[static_cast<std::size_t>(node_rows[0]) * motion_stride<D>];
        for (int d = 0; d < D; ++d) {
          lost += t[1 + D + d] * v[d] - a[d] * t[1 + d];
          work += (t[0] * o.gravity[d] + (loaded ? body.nodes.load[i][d] : 0.0)) * v[d];
        }
      }
      for (int k = 0; k < copies; ++k) {
        double* sums = &body.nodes.sums[static_cast<std::size_t>(node_rows[k]) * sums_stride];
        TALUS_UNROLL
        for (int q = 0; q < sums_stride; ++q) sums[q] = 0;
        double* motion = &body.nodes.motion[static_cast<std::size_t>(node_rows[k]) * motion_stride<D>];
        for (int d = 0; d < D; ++d) motion[D + d] = v[d];
      }
      if (!o.moving) {
        for (int d = 0; d < D; ++d) body.nodes.displacement[i][d] += o.dt * v[d];
      }
    }
    if (c < 0) return;
    works[static_cast<std::size_t>(c)] = {o.dt * work, o.dt * (0.5 * lost + work)};
  });
  complete_chunks(body, works);
  for (const auto& work : works) {
    body.work.external += work[0];
    body.work.mapping += work[1];
  }
  body.nodes.motion_step = o.dt;
}

template void solve_momentum<2>(Dry, Body<2>&, const StepOptions<2>&);
template void solve_momentum<3>(Dry, Body<3>&, const StepOptions<3>&);
template void remap_momentum<2>(Dry, Body<2>&, const StepOptions<2>&);
template void remap_momentum<3>(Dry, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
