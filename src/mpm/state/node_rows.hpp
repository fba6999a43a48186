// SPDX-License-Identifier: MIT
#pragma once
// Node loops: pieces of nodes, sums over the rows of a node, and the free part of forces and velocities under a
// constraint.

#include <algorithm>
#include <cmath>

#include "base/rows.hpp"
#include "mpm/state/partition.hpp"

namespace talus::mpm {

/// P2G: adds N values from column First on to the sums of the k-th nodes of the elements of block `b`.
template <int N, int First, int D>
TALUS_KERNEL void add_to_sums(Body<D>& body, int b, int k, const Pack* values) {
  const std::size_t at = (static_cast<std::size_t>(b) * (D + 1) + static_cast<std::size_t>(k)) * lane_width;
  add_rows<N, First>(body.nodes.sums.data(), &body.layout->connectivity[at], values);
}

/// The first N sums of a node, over the rows that it has in chunks. Rows are Stride doubles long.
template <int N, int Stride, class Array>
TALUS_KERNEL void sum_rows(const Array& sums, const int* rows, int count, double* t) {
  const double* s = sums.data() + static_cast<std::int64_t>(rows[0]) * Stride;
  TALUS_UNROLL
  for (int q = 0; q < N; ++q) t[q] = s[q];
  for (int c = 1; c < count; ++c) {
    s = sums.data() + static_cast<std::int64_t>(rows[c]) * Stride;
    TALUS_UNROLL
    for (int q = 0; q < N; ++q) t[q] += s[q];
  }
}

/// Component of `f` in the free directions of a node.
template <int D>
TALUS_KERNEL Vec<D> free_part(const Constraint<D>& c, std::type_identity_t<Vec<D>> f) {
  for (int k = 0; k < c.fixed_count; ++k) {
    const double along = dot(f, c.fixed[k]);
    for (int d = 0; d < D; ++d) f[d] -= along * c.fixed[k][d];
  }
  return f;
}

/// Component of a force that neither the fixed directions nor a pressed wall, friction included, can take: a block that
/// sticks to a frictional wall is at rest.
template <int D>
TALUS_PORTABLE Vec<D> unsupported_part(const Constraint<D>& c, bool pressed, std::type_identity_t<Vec<D>> f) {
  if (c.has_wall && pressed) {
    const double into = std::max(0.0, dot(f, c.wall_normal));
    for (int d = 0; d < D; ++d) f[d] -= into * c.wall_normal[d];
    const double along = norm(f), held = c.friction * into;
    for (int d = 0; d < D; ++d) f[d] *= along > held ? 1 - held / along : 0.0;
  }
  return free_part(c, f);
}

/// Velocity after the remap under a constraint. A node that a wall stopped does not leave the wall within the same
/// step: the remap mixes in the accelerations of neighbours, and a rebound from them would strain the soil without the
/// work of any force.
template <class C, std::size_t D>
TALUS_PORTABLE std::array<double, D> constrain_remapped(const C& conditions, int c, std::array<double, D> v, double t) {
  const auto& k = conditions.constraints[static_cast<std::size_t>(c)];
  if (k.has_wall && conditions.pressed[static_cast<std::size_t>(c)]) {
    const double away = std::min(0.0, dot(v, k.wall_normal));
    for (std::size_t d = 0; d < D; ++d) v[d] -= away * k.wall_normal[d];
  }
  return k.has_wall || k.factor >= 0 ? constrain_velocity(conditions, k, v, t) : free_part(k, v);
}

/// Sums over a piece of a node loop.
struct PieceSums {
  double damped = 0, walls = 0, drag = 0, mapping = 0;
  double out_of_balance2 = 0, external2 = 0, kinetic = 0, speed2 = 0;
  int fastest = -1;

  /// NaN wins over any number; otherwise an unstable run would pass for one at rest.
  TALUS_PORTABLE void note_speed(double of_node2, int node) {
    if (of_node2 <= speed2 || std::isnan(speed2)) return;
    speed2 = of_node2;
    fastest = node;
  }
  /// Adds the sums of the next piece.
  TALUS_PORTABLE void add(const PieceSums& next) {
    damped += next.damped;
    walls += next.walls;
    drag += next.drag;
    mapping += next.mapping;
    out_of_balance2 += next.out_of_balance2;
    external2 += next.external2;
    kinetic += next.kinetic;
    note_speed(next.speed2, next.fastest);
  }
};

/// Calls solve(begin, end, sums) for the pieces of the nodes after the halo exchange of `rows`, and adds their sums in
/// the order of the pieces.
template <int D, class Solve>
void solve_pieces(Body<D>& body, int threads, AlignedVector<double>& rows, int stride, bool monitor, Solve&& solve) {
  body.conditions.pressed.resize(body.conditions.constraints.size());
  std::vector<PieceSums> pieces(static_cast<std::size_t>(body.layout->chunks));
  update_and_for_node_pieces(body, threads, rows, stride, [&](int begin, int end, int c) {
    PieceSums mine;  // on the stack: neighbouring pieces must not share a cache line
    solve(begin, end, mine);
    if (c >= 0) pieces[static_cast<std::size_t>(c)] = mine;
  });
  complete_chunks(body, pieces);
  PieceSums all;
  for (const PieceSums& s : pieces) {
    body.work.damped += s.damped;
    body.work.walls += s.walls;
    body.work.drag += s.drag;
    body.work.mapping += s.mapping;
    all.out_of_balance2 += s.out_of_balance2;
    all.external2 += s.external2;
    all.kinetic += s.kinetic;
    all.note_speed(s.speed2, s.fastest);
  }
  if (!monitor) return;
  body.monitor = {std::sqrt(all.out_of_balance2), std::sqrt(all.external2), all.kinetic, std::sqrt(all.speed2),
                  all.fastest};
}

}  // namespace talus::mpm
