// SPDX-License-Identifier: MIT
#pragma once
// Kernels of the equation of the nodal pressures (T22.5), element by element and node by node, for a body B here or on
// a GPU.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/aligned.hpp"
#include "base/rows.hpp"
#include "mesh/mesh.hpp"
#include "mpm/kernels/held_water.hpp"
#include "mpm/kernels/water_surface.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/node_rows.hpp"

namespace talus::mpm {

inline constexpr int most_rounds = 20;           ///< linear solutions in a step, until lines and surface state fit
inline constexpr int most_iterations = 5000;     ///< of the linear solver
inline constexpr double round_reduction = 0.03;  ///< of the residual in a round (inexact Newton method)
inline constexpr double smallest_change = 1e-3;  ///< change of the pressures that counts as zero [Pa]

/// Hydraulic condition of the surface at a node in one step.
struct SurfaceWater {
  bool is_given = false;  ///< the pressure is prescribed
  bool may_pond = false;  ///< ponding or outflow at zero pressure is possible
  bool is_rain = false;
  double pressure = 0;  ///< [Pa]
  double inflow = 0;    ///< supplied [m³/s]
};

/// Equation of one step: matrix, residual and search direction. Array: a list here, a view on a GPU. Matrix entries
/// are stored like the columns of the graph, entries with D components by slice, component and lane (find_component()).
template <int D, template <class> class Array>
struct PressureArrays {
  Array<double> through;  ///< flow out of the row's node per pressure at the column's [m³/Pa]
  Array<double> growth;   ///< growth of the row's pores per displacement of the column's node, D components [m²]
  Array<double> push;     ///< force of the pressure at the column's node on the row's, D components [m²]
  Array<double> drive;    ///< right-hand side for the present lines of the water contents [m³]
  Array<double> storage, diagonal, inverse;  ///< parts of the diagonal, and its inverse, zero at fixed nodes
  Array<double> grown, drained, pores;
  Array<double> r, z, d, q;              ///< vectors of the conjugate gradients
  Array<std::array<double, 4>> carried;  ///< displacement by the pressures, and in the last column the pressure
  Array<std::uint8_t> fixed;
  Array<SurfaceWater> surface;
  Array<HeldLine> lines;
  // By element.
  Array<double> divergence;
  Array<Vec<D>> flux, lift;
};
template <class T>
using ArrayHere = AlignedVector<T>;

/// Place of component `d` of entry `n` in rows of slices of `width` nodes.
template <int D, int width>
TALUS_KERNEL std::size_t find_component(int n, int d) {
  const auto entry = static_cast<unsigned>(n);
  return static_cast<std::size_t>(entry / width) * (D * width) + static_cast<unsigned>(d) * width + entry % width;
}

/// Kernels of the equation. S: PressureArrays.
template <class B, class S>
struct PressureLines {
  static constexpr int D = B::dimension, width = B::width;
  B& body;
  S& s;
  const StepOptions<D>& o;

  /// Sums the pores of node `i` over the materials. Returns whether the node is wet; dry nodes take no part.
  TALUS_PORTABLE bool sum_pores(int i) const {
    auto& m = body.water.darcy;
    s.pores[i] = 0;
    for (std::size_t k = 0; k < m.node_pores.size(); ++k) s.pores[i] += m.node_pores[k][i];
    if (s.pores[i] > 0) return true;
    m.change[i] = m.out[i] = m.passed[i] = 0;
    return false;
  }

  /// Evaluates the hydraulic condition at node `i`, whose area must be known.
  TALUS_PORTABLE void find_surface(int i) const {
    const auto& water = body.water;
    const auto& m = water.darcy;
    s.surface[i] = {};
    const double area = norm(m.area[i]);
    if (area == 0) return;
    SurfaceWater& of_node = s.surface[i];
    const auto& condition = water.surfaces[water.surface_of_node[i]];
    const OuterWater<D> outer(water.density, o.gravity);
    const double outside = find_outer_pressure(body, i, i, outer).value_or(0);
    of_node.is_given = condition.kind == SurfaceKind::open || condition.kind == SurfaceKind::pressure || outside < 0;
    if (of_node.is_given) {
      of_node.pressure = outside;
      return;
    }
    of_node.may_pond = condition.kind != SurfaceKind::flux;
    of_node.is_rain = condition.kind == SurfaceKind::rain;
    Vec<D> normal = m.area[i];
    for (double& n : normal) n /= area;
    of_node.inflow = -area * find_offered_flux<D>(condition, normal, m.pressure[i], outer.up, body.time);
  }

  /// Divergence of the predicted velocity and Darcy flux of element `e` at p^n (T22.4).
  TALUS_PORTABLE void assemble_element(int e) const {
    const auto& m = body.water.darcy;
    const auto& mesh = body.mesh();
    s.divergence[e] = 0;
    s.flux[e] = Vec<D>{};
    if (!(body.water.volume[e] > 0)) return;
    Vec<D> gradient{}, mean{};
    for (int k = 0; k <= D; ++k) {
      const int node = mesh.elements[e][k];
      const Vec<D> b = mesh::find_shape_gradient(mesh, e, k);
      s.divergence[e] += dot(b, m.velocity[node]);
      for (int d = 0; d < D; ++d) {
        gradient[d] += b[d] * m.pressure[node];
        mean[d] += m.acceleration[node][d] / (D + 1);
      }
    }
    for (int d = 0; d < D; ++d) {
      s.lift[e][d] = body.water.density * (o.gravity[d] - mean[d]);
      s.flux[e][d] = m.conductive[e] * (gradient[d] + s.lift[e][d]);
    }
  }

  /// Sets the rows and vectors of the nodes of T from `i` on to zero; those of dry nodes stay zero.
  template <class T>
  void clear(int i) const {
    const auto& graph = *body.water.darcy.graph;
    for (int n = graph.row_start[i], end = find_row_end<T>(i); n < end; n += width) {
      store_unaligned(&s.through[n], T(0.0));
      for (int d = 0; d < D; ++d) {
        store_unaligned(&s.push[find_component<D, width>(n, d)], T(0.0));
        store_unaligned(&s.growth[find_component<D, width>(n, d)], T(0.0));
      }
    }
    for (auto* field : {&s.drive, &s.storage, &s.diagonal, &s.inverse, &s.r, &s.z, &s.d})
      store_unaligned(&(*field)[i], T(0.0));
  }
  /// Adds row and source of node `i` (T22.5); the row must be zero before.
  TALUS_PORTABLE void assemble_node(int i) const {
    const auto& m = body.water.darcy;
    const auto& mesh = body.mesh();
    const auto& graph = *m.graph;
    double grown = 0, drained = 0;
    for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t) {
      const int e = graph.element[t], local = graph.local[t];
      if (!(body.water.volume[e] > 0)) continue;
      const Vec<D> b = mesh::find_shape_gradient(mesh, e, local);
      grown += o.dt * m.saturated[e] * s.divergence[e] / (D + 1);
      drained += m.drawn[e] / (D + 1) - o.dt * dot(b, s.flux[e]);
      const double squeeze = m.coupling[e] / (D + 1), conductive = o.dt * m.conductive[e],
                   soft = m.soft[e] / ((D + 1) * (D + 2));
      for (int k = 0; k <= D; ++k) {
        const Vec<D> other = mesh::find_shape_gradient(mesh, e, k);
        const double same = k == local ? 1.0 : 0.0;
        const int n = graph.place[static_cast<std::size_t>(t) * (D + 1) + static_cast<std::size_t>(k)];
        s.through[n] += conductive * dot(b, other) + soft * (same - 1.0 / (D + 1));
        for (int d = 0; d < D; ++d) {
          s.push[find_component<D, width>(n, d)] += squeeze * b[d];
          s.growth[find_component<D, width>(n, d)] += squeeze * other[d];
        }
      }
    }
    s.grown[i] = grown;
    s.drained[i] = drained;
  }

  TALUS_PORTABLE void find_diagonal(int i) const {
    const auto& m = body.water.darcy;
    const auto& graph = *m.graph;
    double sum = s.through[graph.row_start[i]];
    for (int n = graph.row_start[i]; n < graph.row_end(i); n += width) {
      const int j = graph.column[n];
      Vec<D> growth;
      for (int d = 0; d < D; ++d) growth[d] = s.growth[find_component<D, width>(n, d)];
      sum += m.mobility[j] * dot(hold(j, growth), growth);
    }
    s.diagonal[i] = sum;
  }

  /// Returns whether the content of node `i` is not linear in the pressure.
  TALUS_PORTABLE bool start_line(int i) const {
    const auto& m = body.water.darcy;
    s.lines[i] = HeldLine::start(held(i), m.pressure[i]);
    s.storage[i] = s.lines[i].storage;
    s.drive[i] =
        s.grown[i] + s.drained[i] + s.lines[i].at(m.pressure[i]) - m.node_water[i] - o.dt * s.surface[i].inflow;
    return s.lines[i].drains;
  }
  /// Updates the line of the water content of node `i`, and drive and residual to it. Returns what the content itself
  /// adds to the square of the residual.
  TALUS_PORTABLE double bend_line(int i, int round) const {
    const auto& m = body.water.darcy;
    HeldLine& line = s.lines[i];
    const double start = m.pressure[i], next = start + m.change[i];
    if (!s.fixed[i] && line.stays_full(next, s.r[i], s.diagonal[i])) return 0;
    const double at_start = line.at(start), at_next = line.at(next);
    double error = 0;
    if (s.fixed[i])
      line.bend_at(held(i), next);
    else
      error = line.bend(held(i), next, s.r[i], s.diagonal[i], round);
    const double added = error * (2 * s.r[i] + error) * s.inverse[i];
    s.storage[i] = line.storage;
    s.drive[i] += line.at(start) - at_start;
    s.r[i] += line.at(next) - at_next;
    find_inverse(i);
    return added;
  }

  // Products and vectors of the conjugate gradients: for the nodes from `i` on in the lanes of T, or for one node.

  /// Displacement of node `j` by the pressures x.
  template <class T>
  TALUS_KERNEL void push(const auto& x, int j) const {
    const auto& m = body.water.darcy;
    const auto& graph = *m.graph;
    T row[4] = {};
    for (int n = graph.row_start[j], end = find_row_end<T>(j); n < end; n += width) {
      const T p = gather<T>(x.data(), &graph.column[n]);
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) row[d] += p * load_unaligned<T>(&s.push[find_component<D, width>(n, d)]);
    }
    const T mobility = load_unaligned<T>(&m.mobility[j]);
    for (int d = 0; d < D; ++d) row[d] *= mobility;
    row[3] = load_unaligned<T>(&x[j]);
    store_four(s.carried[j].data(), row);
    for (int l = 0; l < LaneTraits<T>::width; ++l) hold_carried(j + l);
  }
  /// Product of the matrix with x, which push() has carried, into q. Returns its product with x.
  template <class T>
  TALUS_KERNEL T multiply(const auto& x, int i) const {
    const auto& graph = *body.water.darcy.graph;
    const T own = load_unaligned<T>(&x[i]);
    T sum = load_unaligned<T>(&s.storage[i]) * own;
    for (int n = graph.row_start[i], end = find_row_end<T>(i); n < end; n += width) {
      T row[4];
      load_rows<4, 4>(s.carried.data()->data(), &graph.column[n], row);
      sum += load_unaligned<T>(&s.through[n]) * row[3];
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) sum += row[d] * load_unaligned<T>(&s.growth[find_component<D, width>(n, d)]);
    }
    store_unaligned(&s.q[i], sum);
    return own * sum;
  }
  /// Flow out of node `i` with the pressures x, into q.
  template <class T>
  TALUS_KERNEL void find_flow(const auto& x, int i) const {
    const auto& graph = *body.water.darcy.graph;
    T sum(0.0);
    for (int n = graph.row_start[i], end = find_row_end<T>(i); n < end; n += width)
      sum += load_unaligned<T>(&s.through[n]) * gather<T>(x.data(), &graph.column[n]);
    store_unaligned(&s.q[i], sum);
  }
  /// Contribution of node `i` to the square that the residual is compared with.
  template <class T>
  TALUS_KERNEL T find_scale(int i) const {
    const T stiffness = load_unaligned<T>(&s.diagonal[i]) + load_unaligned<T>(&s.storage[i]),
            b = load_unaligned<T>(&s.drive[i]), x = load_unaligned<T>(&body.water.darcy.change[i]),
            inverse = load_unaligned<T>(&s.inverse[i]);
    return select(inverse > T(0.0), b * b * inverse, x * x * stiffness) + smallest_change * smallest_change * stiffness;
  }
  /// Residual of the equation, whose product with the change must be q. Returns r·z.
  template <class T>
  TALUS_KERNEL T start_residual(int i) const {
    store_unaligned(&s.r[i], load_unaligned<T>(&s.drive[i]) - load_unaligned<T>(&s.q[i]));
    return start_direction<T>(i);
  }
  template <class T>
  TALUS_KERNEL T start_direction(int i) const {
    const T r = load_unaligned<T>(&s.r[i]), z = r * load_unaligned<T>(&s.inverse[i]);
    store_unaligned(&s.z[i], z);
    store_unaligned(&s.d[i], z);
    return r * z;
  }
  /// Adds a step along the direction. Returns r·z.
  template <class T>
  TALUS_KERNEL T advance_solution(double step, int i) const {
    double* x = &body.water.darcy.change[i];
    store_unaligned(x, load_unaligned<T>(x) + step * load_unaligned<T>(&s.d[i]));
    const T r = load_unaligned<T>(&s.r[i]) - step * load_unaligned<T>(&s.q[i]),
            z = r * load_unaligned<T>(&s.inverse[i]);
    store_unaligned(&s.r[i], r);
    store_unaligned(&s.z[i], z);
    return r * z;
  }
  template <class T>
  TALUS_KERNEL void update_direction(double share, int i) const {
    store_unaligned(&s.d[i], load_unaligned<T>(&s.z[i]) + share * load_unaligned<T>(&s.d[i]));
  }

  /// Sets which pressures are prescribed in this round.
  TALUS_PORTABLE void fix_node(int i) const {
    auto& m = body.water.darcy;
    const SurfaceWater& of_node = s.surface[i];
    s.fixed[i] = of_node.is_given || (of_node.may_pond && m.ponded[i] != 0);
    if (s.fixed[i]) m.change[i] = (of_node.is_given ? of_node.pressure : 0.0) - m.pressure[i];
    find_inverse(i);
  }
  /// Water that passes the surface at node `i` [m³]; the residual of a fixed node is the flow that its pressure needs.
  TALUS_PORTABLE void find_passed(int i) const {
    body.water.darcy.passed[i] = -o.dt * s.surface[i].inflow - (s.fixed[i] ? s.r[i] : 0.0);
  }
  /// Ponding: the pressure is zero where it would become positive, until more water would have to enter than is
  /// offered. Returns whether the state of node `i` was already right.
  TALUS_PORTABLE bool settle_surface(int i) const {
    auto& m = body.water.darcy;
    if (!s.surface[i].may_pond) return true;
    const bool stands =
        m.ponded[i] ? -m.passed[i] <= o.dt * s.surface[i].inflow * (1 + 1e-12) : m.pressure[i] + m.change[i] < 0;
    const bool settled = stands == (m.ponded[i] != 0);
    m.ponded[i] = stands;
    return settled;
  }

  /// Water that leaves node `i` [m³]; q must be the flow between the nodes.
  TALUS_PORTABLE void find_out(int i) const {
    auto& m = body.water.darcy;
    m.out[i] = s.drained[i] - s.q[i] + m.passed[i];
  }
  /// Water lost per pore volume of element `e` (T22.6).
  TALUS_PORTABLE void distribute_water(int e) const {
    auto& m = body.water.darcy;
    m.share[e] = 0;
    if (!(body.water.volume[e] > 0)) return;
    for (int node : body.mesh().elements[e]) m.share[e] += m.out[node] / s.pores[node] / (D + 1);
  }
  /// Water that the elements of node `i` do not represent: it stays with the node, and decreases as the soil moves over
  /// the size of an element (T22.7).
  TALUS_PORTABLE void keep_own(int i) const {
    auto& m = body.water.darcy;
    const auto& graph = *m.graph;
    m.own[i] -= m.out[i];
    for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t) {
      const int e = graph.element[t];
      for (std::size_t k = 0; k < m.pores.size(); ++k) m.own[i] += m.pores[k][e] * m.share[e] / (D + 1);
    }
    if (o.moving) m.own[i] *= std::max(0.0, 1 - o.dt * norm(m.velocity[i]) / graph.size[i]);
  }
  /// Water [kg] that has passed the surface at node `i` in this step.
  TALUS_PORTABLE SurfaceBudget count_water(int i) const {
    SurfaceBudget budget;
    const double out = body.water.density * body.water.darcy.passed[i];
    (out > 0 ? budget.left : budget.entered) = std::abs(out);
    const double offered = body.water.density * o.dt * s.surface[i].inflow;
    if (!s.surface[i].is_rain || !(offered > 0)) return budget;
    budget.supplied = offered;
    budget.runoff = offered - std::max(0.0, -out);
    return budget;
  }
  /// Darcy flux at the end of the step, and pressure, of element `e`.
  TALUS_PORTABLE void find_end(int e) const {
    auto& water = body.water;
    auto& m = water.darcy;
    const auto& mesh = body.mesh();
    for (int d = 0; d < D; ++d) m.flux[d][e] = 0;
    if (!(water.volume[e] > 0)) return;
    double mean = 0;
    Vec<D> gradient{};
    for (int k = 0; k <= D; ++k) {
      const double p = m.pressure[mesh.elements[e][k]];
      const Vec<D> b = mesh::find_shape_gradient(mesh, e, k);
      mean += p / (D + 1);
      for (int d = 0; d < D; ++d) gradient[d] += p * b[d];
    }
    water.mean_pressure[e] = mean;
    if (!(m.water[e] > 0)) return;
    for (int d = 0; d < D; ++d)
      m.flux[d][e] = m.conductive[e] / (water.stretch[e] * m.water[e]) * (gradient[d] + s.lift[e][d]);
  }

 private:
  /// End of the row of node `i`, or of the longest row of the slice that starts with it.
  template <class T>
  TALUS_KERNEL int find_row_end(int i) const {
    const auto& graph = *body.water.darcy.graph;
    return LaneTraits<T>::width == 1 ? graph.row_end(i) : graph.row_start[i + LaneTraits<T>::width];
  }
  TALUS_PORTABLE void find_inverse(int i) const {
    s.inverse[i] = s.fixed[i] ? 0.0 : 1 / (s.diagonal[i] + s.storage[i]);
  }
  /// Applies the constraint of node `j` to its displacement.
  TALUS_KERNEL void hold_carried(int j) const {
    if (body.conditions.constraint_of_node[j] < 0) return;
    Vec<D> u;
    for (int d = 0; d < D; ++d) u[d] = s.carried[j][static_cast<std::size_t>(d)];
    u = hold(j, u);
    for (int d = 0; d < D; ++d) s.carried[j][static_cast<std::size_t>(d)] = u[d];
  }
  TALUS_PORTABLE auto held(int i) const { return HeldWater(body.water.laws, body.water.darcy.node_pores, i); }

  /// Projection Π of a vector at node `i` onto its free directions.
  TALUS_PORTABLE Vec<D> hold(int i, Vec<D> v) const {
    const int c = body.conditions.constraint_of_node[i];
    if (c < 0) return v;
    const Constraint<D>& constraint = body.conditions.constraints[static_cast<std::size_t>(c)];
    v = free_part(constraint, v);
    if (constraint.has_wall && body.conditions.pressed[static_cast<std::size_t>(c)]) {
      const double along = dot(v, constraint.wall_normal);
      for (int d = 0; d < D; ++d) v[d] -= along * constraint.wall_normal[d];
    }
    return v;
  }
};

}  // namespace talus::mpm
