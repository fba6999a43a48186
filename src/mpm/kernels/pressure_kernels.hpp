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
#include "mpm/kernels/flow_kernels.hpp"
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

/// Coefficients of the elements from which the rows were assembled. A GPU assembles all rows in every step.
template <template <class> class Array>
struct AssembledFrom {
  Array<double> coupling, conductive, soft;
  Array<double> changed;  ///< 1 where the coefficients of the step differ
  double dt = 0;          ///< [s]
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
  Array<double> growth_of, flux[D], lift[D];  ///< growth of a node's pores in it [m³]; Darcy flux; its part by gravity
  Array<double> lost;                         ///< a node's part of the water lost (T22.6) [m³]
  AssembledFrom<Array> assembled_from;
};
template <class T>
using ArrayHere = AlignedVector<T>;

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

  /// Growth of the pores with the predicted velocity, and Darcy flux at p^n, of the elements of T from `e` on (T22.4).
  template <class T>
  TALUS_PORTABLE void assemble_elements(int e) const {
    const auto& m = body.water.darcy;
    const MaskOf<T> wet = load_unaligned<T>(&body.water.volume[e]) > T(0.0);
    T growth(0.0), flux[D] = {};
    if (any(wet)) {
      T b[D + 1][D], divergence(0.0), gradient[D] = {}, mean[D] = {};
      load_gradients<T>(body, e, b);
      TALUS_UNROLL
      for (int k = 0; k <= D; ++k) {
        const int* nodes = find_nodes<T>(body, e, k);
        const T pressure = gather<T>(m.pressure.data(), nodes);
        TALUS_UNROLL
        for (int d = 0; d < D; ++d) {
          divergence += b[k][d] * gather_component<T>(m.velocity, nodes, d);
          gradient[d] += b[k][d] * pressure;
          mean[d] += gather_component<T>(m.acceleration, nodes, d);
        }
      }
      const T conductive = load_unaligned<T>(&m.conductive[e]);
      growth = select(wet, load_unaligned<T>(&m.saturated[e]) * divergence * (o.dt / (D + 1)), T(0.0));
      for (int d = 0; d < D; ++d) {
        const T lift = body.water.density * (o.gravity[d] - mean[d] * (1.0 / (D + 1)));
        store_unaligned(&s.lift[d][e], lift);
        flux[d] = select(wet, conductive * (gradient[d] + lift), T(0.0));
      }
    }
    store_unaligned(&s.growth_of[e], growth);
    for (int d = 0; d < D; ++d) store_unaligned(&s.flux[d][e], flux[d]);
  }

  /// Marks the elements of T from `e` on whose coefficients are not bitwise those of their rows, with `all` every one.
  template <class T>
  void mark_changed(int e, bool all) const {
    const auto& m = body.water.darcy;
    MaskOf<T> same(!all);
    const auto compare = [&](auto& of_rows, const auto& now) {
      const T value = load_unaligned<T>(&now[e]);
      same = same && load_unaligned<T>(&of_rows[e]) == value;
      store_unaligned(&of_rows[e], value);
    };
    compare(s.assembled_from.coupling, m.coupling);
    compare(s.assembled_from.conductive, m.conductive);
    compare(s.assembled_from.soft, m.soft);
    store_unaligned(&s.assembled_from.changed[e], select(same, T(0.0), T(1.0)));
  }
  /// Assembles the rows of the nodes of T from `i` on, if an element around them has changed; those of dry nodes are
  /// zero.
  template <class T>
  void assemble_rows(int i) const {
    const auto& graph = *body.water.darcy.graph;
    T changed(0.0);
    for (int t = graph.touch_start[i], end = graph.template find_touch_end<T>(i); t < end; t += graph.touch_stride)
      changed += graph.template gather_element<T>(s.assembled_from.changed, t);
    if (!any(changed > T(0.0))) return;
    for (int n = graph.row_start[i], end = find_row_end<T>(i); n < end; n += width) {
      store_unaligned(&s.through[n], T(0.0));
      for (int d = 0; d < D; ++d) {
        store_unaligned(&s.push[find_component<D, width>(n, d)], T(0.0));
        store_unaligned(&s.growth[find_component<D, width>(n, d)], T(0.0));
      }
    }
    for (int l = i; l < i + LaneTraits<T>::width; ++l) assemble_node(l);
  }
  /// Sets the vectors of the nodes of T from `i` on to zero; those of dry nodes stay zero.
  template <class T>
  void clear(int i) const {
    for (auto* field : {&s.drive, &s.storage, &s.diagonal, &s.inverse, &s.r, &s.z, &s.d})
      store_unaligned(&(*field)[i], T(0.0));
  }
  /// Source of the nodes of T from `i` on (T22.5).
  template <class T>
  TALUS_PORTABLE void find_source(int i) const {
    const auto& m = body.water.darcy;
    const auto& graph = *m.graph;
    T grown(0.0), drawn(0.0), flow(0.0);
    for (int t = graph.touch_start[i], end = graph.template find_touch_end<T>(i); t < end; t += graph.touch_stride) {
      const MaskOf<T> are = graph.template are_touches<T>(i, t);
      grown += select(are, graph.template gather_element<T>(s.growth_of, t), T(0.0));
      drawn += select(are, graph.template gather_element<T>(m.drawn, t), T(0.0));
      T b[D];
      graph.template load_gradient<T>(body.mesh(), t, b);
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) flow += b[d] * graph.template gather_element<T>(s.flux[d], t);
    }
    store_unaligned(&s.grown[i], grown);
    store_unaligned(&s.drained[i], drawn * (1.0 / (D + 1)) - o.dt * flow);
  }
  /// Adds the row of node `i` (T22.5), which must be zero before.
  TALUS_PORTABLE void assemble_node(int i) const {
    const auto& m = body.water.darcy;
    const auto& mesh = body.mesh();
    const auto& graph = *m.graph;
    for (int t = graph.touch_start[i]; t < graph.touch_end(i); t += graph.touch_stride) {
      const int e = graph.element[t], local = graph.local[t];
      if (!(body.water.volume[e] > 0)) continue;
      const Vec<D> b = mesh::find_shape_gradient(mesh, e, local);
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
  }

  template <class T>
  TALUS_PORTABLE void find_diagonal(int i) const {
    const auto& m = body.water.darcy;
    const auto& graph = *m.graph;
    T sum = load_unaligned<T>(&s.through[graph.row_start[i]]);
    for (int n = graph.row_start[i], end = find_row_end<T>(i); n < end; n += width) {
      T square(0.0);
      TALUS_UNROLL
      for (int d = 0; d < D; ++d) {
        const T growth = load_unaligned<T>(&s.growth[find_component<D, width>(n, d)]);
        square += growth * growth;
      }
      const bool are_free = are_negative<T>(body.conditions.constraint_of_node.data(), &graph.column[n]);
      for (int l = 0; l < LaneTraits<T>::width && !are_free; ++l) {
        const int j = graph.column[n + l];
        if (body.conditions.constraint_of_node[j] < 0) continue;
        Vec<D> growth;
        for (int d = 0; d < D; ++d) growth[d] = s.growth[find_component<D, width>(n + l, d)];
        set_lane(square, l, dot(hold(j, growth), growth));
      }
      sum += gather<T>(m.mobility.data(), &graph.column[n]) * square;
    }
    store_unaligned(&s.diagonal[i], sum);
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
    s.z[i] = m.out[i] / s.pores[i];
  }
  /// Water lost per pore volume of the elements of T from `e` on (T22.6); z must be the outflow per pore volume.
  template <class T>
  TALUS_PORTABLE void distribute_water(int e) const {
    auto& m = body.water.darcy;
    const MaskOf<T> wet = load_unaligned<T>(&body.water.volume[e]) > T(0.0);
    const T share = any(wet) ? select(wet, find_mean_of_nodes<T>(body, s.z, e), T(0.0)) : T(0.0);
    T pores(0.0);
    for (std::size_t k = 0; k < m.pores.size(); ++k) pores += load_unaligned<T>(&m.pores[k][e]);
    store_unaligned(&m.share[e], share);
    store_unaligned(&s.lost[e], pores * share * (1.0 / (D + 1)));
  }
  /// Water that the elements of the nodes of T from `i` on do not represent: it stays with the node, and decreases as
  /// the soil moves over the size of an element (T22.7).
  template <class T>
  TALUS_PORTABLE void keep_own(int i) const {
    auto& m = body.water.darcy;
    const auto& graph = *m.graph;
    T own = load_unaligned<T>(&m.own[i]) - load_unaligned<T>(&m.out[i]);
    for (int t = graph.touch_start[i], end = graph.template find_touch_end<T>(i); t < end; t += graph.touch_stride)
      own += select(graph.template are_touches<T>(i, t), graph.template gather_element<T>(s.lost, t), T(0.0));
    store_unaligned(&m.own[i], own);
    if (!o.moving) return;
    for (int l = i; l < i + LaneTraits<T>::width; ++l)
      m.own[l] *= std::max(0.0, 1 - o.dt * norm(m.velocity[l]) / graph.size[l]);
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
  /// Darcy flux at the end of the step, and pressure, of the elements of T from `e` on.
  template <class T>
  TALUS_PORTABLE void find_end(int e) const {
    auto& water = body.water;
    auto& m = water.darcy;
    const MaskOf<T> wet = load_unaligned<T>(&water.volume[e]) > T(0.0);
    T flux[D] = {};
    if (any(wet)) {
      T b[D + 1][D], mean(0.0), gradient[D] = {};
      load_gradients<T>(body, e, b);
      TALUS_UNROLL
      for (int k = 0; k <= D; ++k) {
        const T p = gather<T>(m.pressure.data(), find_nodes<T>(body, e, k));
        mean += p * (1.0 / (D + 1));
        TALUS_UNROLL
        for (int d = 0; d < D; ++d) gradient[d] += p * b[k][d];
      }
      mean = select(wet, mean, load_unaligned<T>(&water.mean_pressure[e]));
      store_unaligned(&water.mean_pressure[e], mean);
      store_unaligned(&m.pressing[e], select(wet, load_unaligned<T>(&m.effective[e]) * mean, T(0.0)));
      const T content = load_unaligned<T>(&m.water[e]), conductive = load_unaligned<T>(&m.conductive[e]),
              factor = conductive / (load_unaligned<T>(&water.stretch[e]) * content);
      const MaskOf<T> flows = wet && content > T(0.0);
      for (int d = 0; d < D; ++d)
        flux[d] = select(flows, factor * (gradient[d] + load_unaligned<T>(&s.lift[d][e])), T(0.0));
    }
    for (int d = 0; d < D; ++d) store_unaligned(&m.flux[d][e], flux[d]);
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
