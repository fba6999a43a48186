// SPDX-License-Identifier: MIT
#pragma once
// Grid solve: nodal accelerations (2.39), the remap of momentum and the nodal velocities after it (2.41), for a body B
// of packs or of one GPU thread.

#include <array>
#include <cmath>

#include "base/rows.hpp"
#include "mpm/kernels/point_kernels.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/node_rows.hpp"

namespace talus::mpm {

/// Accelerations of the nodes [begin, end) with damping (2.89) and constraints. Adds damping work, work of walls,
/// mapping loss (T9.1) and, if o.monitor is set, the measures of rest to `sums`.
template <class B, int D = B::dimension>
// NOLINTNEXTLINE(readability-function-size): in parts it gets other fused operations, so other bits
TALUS_PORTABLE void solve_nodes(B& body, const StepOptions<D>& o, int begin, int end, PieceSums& sums) {
  const auto& layout = *body.layout;
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
          // The out-of-balance force that damping acts on is taken without the wall's reaction; otherwise damping would
          // shake a resting block with a fraction of its own weight.
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
          // In its fixed directions the node moves with its support: the difference to the velocity that its points
          // bring is removed there. Damping does not act on support reactions.
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
      // Mapping loss (T9.1); remap_nodes() adds the rest of it.
      const double* last = &body.nodes.motion[static_cast<std::size_t>(layout.motion_row(i, 0)) * motion_stride<D> + D];
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
        sums.note_speed(speed2, i);
      }
    }
    for (int k = 0; k < layout.count_motion_rows(i); ++k) {
      double* row = &body.nodes.motion[static_cast<std::size_t>(layout.motion_row(i, k)) * motion_stride<D>];
      for (int d = 0; d < D; ++d) row[d] = a[d];
    }
  }
  sums.damped += damped;
  sums.walls += walls;
  sums.mapping += mapping;
}

/// Remap: adds Δt Σ_j M_ij a_j of block `b` to the momentum of its nodes.
template <class B>
TALUS_KERNEL void remap_block(B& body, int b, double dt) {
  constexpr int D = B::dimension, width = B::width;
  using T = typename B::Lanes;
  const int* rows = &body.layout->connectivity[static_cast<std::size_t>(b) * (D + 1) * width];
  const double* moments = &body.elements.moments[static_cast<std::size_t>(b) * moment_size<D> * width];
  T a[D + 1][D], change[D + 1][D], m[moment_size<D>];
  TALUS_UNROLL
  for (int k = 0; k <= D; ++k) load_rows<D, motion_stride<D>>(body.nodes.motion.data(), rows + k * width, a[k]);
  TALUS_UNROLL
  for (int q = 0; q < moment_size<D>; ++q) m[q] = load<T>(moments + q * width);
  remap_element<D, T>(m, a, dt, change);
  TALUS_UNROLL
  for (int k = 0; k <= D; ++k) add_to_sums<D, 1>(body, b, k, change[k]);
}

/// Velocities of the nodes [begin, end) after the remap (2.41), with constraints; zeroes their sums. Adds to `works`
/// the external work and the mapping loss [J].
template <class B, int D = B::dimension>
TALUS_PORTABLE void remap_nodes(B& body, const StepOptions<D>& o, int begin, int end, std::array<double, 2>& works) {
  const auto& layout = *body.layout;
  const double cutoff = 1e-12 * body.smallest_mass;
  const bool loaded = !body.nodes.load.empty();
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
      const double* a = &body.nodes.motion[static_cast<std::size_t>(layout.motion_row(i, 0)) * motion_stride<D>];
      for (int d = 0; d < D; ++d) {
        lost += t[1 + D + d] * v[d] - a[d] * t[1 + d];
        work += (t[0] * o.gravity[d] + (loaded ? body.nodes.load[i][d] : 0.0)) * v[d];
      }
    }
    for (int k = 0; k < layout.count_motion_rows(i); ++k) {
      const auto row = static_cast<std::size_t>(layout.motion_row(i, k));
      if constexpr (B::adds_to_sums) {
        TALUS_UNROLL
        for (int q = 0; q < sums_stride; ++q) body.nodes.sums[row * sums_stride + static_cast<std::size_t>(q)] = 0;
      }
      double* motion = &body.nodes.motion[row * motion_stride<D>];
      for (int d = 0; d < D; ++d) motion[D + d] = v[d];
    }
    if (!o.moving) {
      for (int d = 0; d < D; ++d) body.nodes.displacement[i][d] += o.dt * v[d];
    }
  }
  works[0] += o.dt * work;
  works[1] += o.dt * (0.5 * lost + work);
}

}  // namespace talus::mpm
