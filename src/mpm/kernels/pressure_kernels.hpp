// SPDX-License-Identifier: MIT
#pragma once
// Kernels of the equation of the nodal pressures (T22.5), element by element and node by node, for a body B here or on
// a GPU.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

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

/// Coupling of node i to the pressure or the displacement of node j.
template <int D>
struct PressureEntry {
  double through = 0;  ///< flow out of i per pressure at j [m³/Pa]
  Vec<D> growth{};     ///< growth of the pores at i per displacement of j [m²]
};

/// Equation of one step: matrix, sources and solution. Array: a list here, a view on a GPU.
template <int D, template <class> class Array>
struct PressureArrays {
  // One entry per column of the graph, in two lists that the products read one after the other.
  Array<PressureEntry<D>> entries;
  Array<Vec<D>> push;  ///< force of the pressure at node j on node i [m²]
  Array<double> storage, diagonal, grown, drained, pores;
  Array<double> r, z, d, q;  ///< vectors of the conjugate gradients
  Array<Vec<D>> pushed;
  Array<std::uint8_t> fixed;
  Array<SurfaceWater> surface;
  Array<HeldLine> lines;
  // By element.
  Array<double> divergence;
  Array<Vec<D>> flux, lift;
};
template <class T>
using ArrayHere = std::vector<T>;

/// Kernels of the equation. S: PressureArrays.
template <class B, class S>
struct PressureLines {
  static constexpr int D = B::dimension;
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

  /// Adds row and source of node `i` (T22.5); both must be zero before.
  TALUS_PORTABLE void assemble_node(int i) const {
    const auto& m = body.water.darcy;
    const auto& mesh = body.mesh();
    const auto& graph = *m.graph;
    for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t) {
      const int e = graph.element[t], local = graph.local[t];
      if (!(body.water.volume[e] > 0)) continue;
      const Vec<D> b = mesh::find_shape_gradient(mesh, e, local);
      s.grown[i] += o.dt * m.saturated[e] * s.divergence[e] / (D + 1);
      s.drained[i] += m.drawn[e] / (D + 1) - o.dt * dot(b, s.flux[e]);
      const double squeeze = m.coupling[e] / (D + 1);
      for (int k = 0; k <= D; ++k) {
        const Vec<D> other = mesh::find_shape_gradient(mesh, e, k);
        const double same = k == local ? 1.0 : 0.0;
        const auto n =
            static_cast<std::size_t>(graph.place[static_cast<std::size_t>(t) * (D + 1) + static_cast<std::size_t>(k)]);
        s.entries[n].through +=
            o.dt * m.conductive[e] * dot(b, other) + m.soft[e] / ((D + 1) * (D + 2)) * (same - 1.0 / (D + 1));
        for (int d = 0; d < D; ++d) {
          s.push[n][d] += squeeze * b[d];
          s.entries[n].growth[d] += squeeze * other[d];
        }
      }
    }
  }

  TALUS_PORTABLE void find_diagonal(int i) const {
    const auto& m = body.water.darcy;
    const auto& graph = *m.graph;
    s.diagonal[i] = s.entries[graph.row_start[i]].through;
    for (int n = graph.row_start[i]; n < graph.row_end(i); n += graph.row_stride) {
      const int j = graph.column[n];
      s.diagonal[i] += m.mobility[j] * dot(hold(j, s.entries[n].growth), s.entries[n].growth);
    }
  }

  TALUS_PORTABLE void start_line(int i) const {
    s.lines[i] = HeldLine::start(held(i), body.water.darcy.pressure[i]);
    s.storage[i] = s.lines[i].storage;
  }
  /// Updates the line of the water content of node `i`, and the residual to it. Writes the square of the residual with
  /// the content itself into q.
  TALUS_PORTABLE void bend_line(int i, int round) const {
    const auto& m = body.water.darcy;
    HeldLine& line = s.lines[i];
    const double next = m.pressure[i] + m.change[i], before = line.at(next), stiffness = find_stiffness(i);
    s.q[i] = 0;
    if (s.fixed[i]) {
      line.bend_at(held(i), next);
    } else {
      const double residual = s.r[i] + line.bend(held(i), next, s.r[i], s.diagonal[i], round);
      s.q[i] = residual * residual / stiffness;
    }
    s.storage[i] = line.storage;
    s.r[i] += line.at(next) - before;
    s.z[i] = s.fixed[i] ? 0.0 : s.r[i] / find_stiffness(i);
  }

  /// Displacement of node `j` by the pressures x.
  TALUS_PORTABLE void push(const auto& x, int j) const {
    const auto& m = body.water.darcy;
    const auto& graph = *m.graph;
    Vec<D> push{};
    for (int n = graph.row_start[j]; n < graph.row_end(j); n += graph.row_stride)
      for (int d = 0; d < D; ++d) push[d] += x[graph.column[n]] * s.push[n][d];
    push = hold(j, push);
    for (int d = 0; d < D; ++d) s.pushed[j][d] = m.mobility[j] * push[d];
  }
  /// Row `i` of the product with x, into q: flow only, or with `whole` also storage and pore growth by the motion that
  /// x causes.
  TALUS_PORTABLE void multiply(const auto& x, bool whole, int i) const {
    const auto& graph = *body.water.darcy.graph;
    double sum = whole ? s.storage[i] * x[i] : 0.0;
    for (int n = graph.row_start[i]; n < graph.row_end(i); n += graph.row_stride) {
      const int j = graph.column[n];
      sum += s.entries[n].through * x[j];
      if (whole) sum += dot(s.entries[n].growth, s.pushed[j]);
    }
    s.q[i] = sum;
  }

  /// Sets which pressures are prescribed in this round.
  TALUS_PORTABLE void fix_node(int i) const {
    auto& m = body.water.darcy;
    const SurfaceWater& of_node = s.surface[i];
    s.fixed[i] = of_node.is_given || (of_node.may_pond && m.ponded[i] != 0);
    if (s.fixed[i]) m.change[i] = (of_node.is_given ? of_node.pressure : 0.0) - m.pressure[i];
  }
  TALUS_PORTABLE double find_stiffness(int i) const { return s.diagonal[i] + s.storage[i]; }
  /// Right-hand side of the equation of node `i` for its line.
  TALUS_PORTABLE double find_drive(int i) const {
    const auto& m = body.water.darcy;
    return s.grown[i] + s.drained[i] + s.lines[i].at(m.pressure[i]) - m.node_water[i] - o.dt * s.surface[i].inflow;
  }
  /// Residual at node `i`; q must be A x.
  TALUS_PORTABLE void start_residual(int i) const {
    s.r[i] = find_drive(i) - s.q[i];
    s.z[i] = s.fixed[i] ? 0.0 : s.r[i] / find_stiffness(i);
  }
  /// Contribution of node `i` to the square that the residual is compared with.
  TALUS_PORTABLE double find_scale(int i) const {
    const double stiffness = find_stiffness(i), b = find_drive(i), x = body.water.darcy.change[i];
    const double known = s.fixed[i] ? x * x * stiffness : b * b / stiffness;
    return known + smallest_change * smallest_change * stiffness;
  }
  TALUS_PORTABLE double find_residual(int i) const { return s.r[i] * s.z[i]; }
  /// Square of the residual at node `i` after bend_line().
  TALUS_PORTABLE double find_error(int i) const { return s.q[i]; }
  TALUS_PORTABLE double find_curvature(int i) const { return s.d[i] * s.q[i]; }
  TALUS_PORTABLE void advance_solution(double step, int i) const {
    body.water.darcy.change[i] += step * s.d[i];
    s.r[i] -= step * s.q[i];
    s.z[i] = s.fixed[i] ? 0.0 : s.r[i] / find_stiffness(i);
  }
  TALUS_PORTABLE void update_direction(double share, int i) const { s.d[i] = s.z[i] + share * s.d[i]; }
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
