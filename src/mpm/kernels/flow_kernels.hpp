// SPDX-License-Identifier: MIT
#pragma once
// Kernels of the Darcy step before the solution of the pressures: contents of elements and nodes (T22.2), coefficients
// of the flow, forces of the pressures and predicted motion (T22.3), for a body B here or on a GPU.

#include <algorithm>
#include <bit>
#include <cmath>

#include "mesh/mesh.hpp"
#include "mpm/kernels/held_water.hpp"
#include "mpm/kernels/laws.hpp"
#include "mpm/kernels/point_kernels.hpp"
#include "mpm/kernels/pore_state.hpp"
#include "mpm/state/body.hpp"
#include "mpm/state/node_rows.hpp"

namespace talus::mpm {

/// Largest |o_i| as a fraction of the node's part of the elements' water: where points leave a node, its own water
/// leaves with them.
inline constexpr double most_own = 0.5;

/// Sums pores, water and integrated volume of element `e`. Returns whether it is wet.
template <class B>
TALUS_PORTABLE bool sum_element(B& body, int e, bool mixed) {
  constexpr int D = B::dimension, width = B::width;
  using P = PointFields<D>;
  auto& water = body.water;
  auto& m = water.darcy;
  const auto& points = body.points;
  const std::size_t materials = water.laws.size();
  for (std::size_t k = 0; k < materials; ++k) m.pores[k][e] = m.volume[k][e] = 0;
  double content = 0, wet = 0, all = 0, pores = 0, pressure = 0;
  int first = -1;
  bool uniform = true;
  for (int k = 0; k < static_cast<int>(points.count[e]); ++k) {
    const std::int64_t slot = points.block_start[e / width] + k;
    const double* p = points.slot(slot) + e % width;
    const int material = points.material[points.id[static_cast<std::size_t>(slot * width + e % width)]];
    const WaterLaw& law = water.laws[material];
    const double volume = p[P::volume * width];
    all += volume;
    uniform = uniform && (first < 0 || first == material);
    first = material;
    if (!law.wet) continue;
    const double here = find_pores(volume, p[P::mass * width] / law.grain_density);
    const double* w = p + water.first_field * width;
    m.pores[material][e] += here;
    pores += here;
    pressure += here * w[WaterFields<D>::pressure * width];
    m.volume[material][e] += volume;
    content += w[WaterFields<D>::mass * width] / law.density;
    wet += volume;
  }
  m.water[e] = content;
  if (pores > 0) water.mean_pressure[e] = pressure / pores;
  const bool full = mixed && uniform && all > 0 && all > body.elements.fill_limit[e];
  water.stretch[e] = full ? body.mesh().volumes[e] / all : 1.0;
  for (std::size_t k = 0; k < materials; ++k)
    m.volume[k][e] = full && m.volume[k][e] > 0 ? body.mesh().volumes[e] : m.volume[k][e] * water.stretch[e];
  water.volume[e] = wet;
  return wet > 0;
}

/// Nodes `k` of the elements of T from `e` on, for gather().
template <class T, class B>
TALUS_KERNEL const int* find_nodes(const B& body, int e, int k) {
  if constexpr (LaneTraits<T>::width == 1)
    return &body.mesh().elements[e][static_cast<std::size_t>(k)];
  else
    return &body.water.darcy.graph->nodes[body.water.darcy.graph->find_corner(e, k)];
}
/// Shape gradients ∇N_k of the elements of T from `e` on [1/m].
template <class T, class B, int D = B::dimension>
TALUS_KERNEL void load_gradients(const B& body, int e, T (&b)[D + 1][D]) {
  TALUS_UNROLL
  for (int d = 0; d < D; ++d) {
    b[0][d] = T(0.0);
    TALUS_UNROLL
    for (int k = 0; k < D; ++k) {
      if constexpr (LaneTraits<T>::width == 1)
        b[k + 1][d] = body.mesh().gradients[e][static_cast<std::size_t>(k * D + d)];
      else
        b[k + 1][d] = load<T>(&body.layout->gradients[static_cast<std::size_t>(e) * D * D + (k * D + d) * B::width]);
      b[0][d] -= b[k + 1][d];
    }
  }
}
/// Component `d` of the vectors of nodes.
template <class T>
TALUS_KERNEL T gather_component(const auto& vectors, const int* nodes, int d) {
  using Vector = std::decay_t<decltype(*vectors.data())>;
  constexpr int size = sizeof(Vector) / sizeof(double);
  const double* base = vectors.data()->data() + d;
  if constexpr (LaneTraits<T>::width == 1) {
    return base[static_cast<std::int64_t>(*nodes) * size];
  } else {
    T value;
    for (int l = 0; l < LaneTraits<T>::width; ++l) set_lane(value, l, base[static_cast<std::int64_t>(nodes[l]) * size]);
    return value;
  }
}
/// Mean of a nodal quantity over the nodes of the elements of T from `e` on.
template <class T, class B, int D = B::dimension>
TALUS_KERNEL T find_mean_of_nodes(const B& body, const auto& field, int e) {
  T sum = gather<T>(field.data(), find_nodes<T>(body, e, 0));
  TALUS_UNROLL
  for (int k = 1; k <= D; ++k) sum += gather<T>(field.data(), find_nodes<T>(body, e, k));
  return sum * (1.0 / (D + 1));
}

/// Contents of the nodes of T from `i` on (T22.2), and the pressures that the step starts from.
template <class T, class B>
TALUS_PORTABLE void start_nodes(B& body, int i, bool first) {
  constexpr int D = B::dimension;
  auto& water = body.water;
  auto& m = water.darcy;
  const auto& graph = *m.graph;
  const int begin = graph.touch_start[i], end = graph.template find_touch_end<T>(i);
  T content(0.0), all(0.0), last(0.0);
  for (int t = begin; t < end; t += graph.touch_stride)
    content += select(graph.template are_touches<T>(i, t), graph.template gather_element<T>(m.water, t), T(0.0));
  for (std::size_t k = 0; k < m.node_pores.size(); ++k) {
    T pores(0.0);
    for (int t = begin; t < end; t += graph.touch_stride) {
      const T here =
          select(graph.template are_touches<T>(i, t), graph.template gather_element<T>(m.pores[k], t), T(0.0));
      pores += here;
      last += here * graph.template gather_element<T>(water.mean_pressure, t);
    }
    store_unaligned(&m.node_pores[k][i], pores * (1.0 / (D + 1)));
    all += pores;
  }
  content = content * (1.0 / (D + 1));
  const MaskOf<T> wet = all > T(0.0);
  if (first)  // the pressure is given, and o_i follows from it
    for (int l = i; l < i + LaneTraits<T>::width; ++l) {
      const HeldWater held(water.laws, m.node_pores, l);
      double here = 0;
      for (int t = graph.touch_start[l]; t < graph.touch_end(l); t += graph.touch_stride)
        here += m.water[graph.element[t]] / (D + 1);
      if (!std::isnan(m.pressure[l])) m.own[l] = HeldLine::start(held, m.pressure[l]).at(m.pressure[l]) - here;
    }
  const T limit = most_own * content, own = lane_min(limit, lane_max(-limit, load_unaligned<T>(&m.own[i])));
  content += own;
  T p = load_unaligned<T>(&m.pressure[i]);
  p = select(p == p, p, last / all);
  const HeldWater<std::decay_t<decltype(water.laws)>, std::decay_t<decltype(m.node_pores)>, T> held(water.laws,
                                                                                                    m.node_pores, i);
  const MaskOf<T> drains = wet && p > T(0.0) && held.drains();
  if (any(drains)) {
    const MaskOf<T> dry = drains && content < held.find_full().held;
    p = select(drains, select(dry, held.find_suction(content, p, dry), T(0.0)), p);
  }
  store_unaligned(&m.pressure[i], select(wet, p, T(NAN)));
  store_unaligned(&m.node_water[i], select(wet, content, T(0.0)));
  store_unaligned(&m.own[i], select(wet, own, T(0.0)));
}

// Coefficients of the flow, forces of the pressures and predicted motion, element by element and node by node.

/// k_r of `law` at suction `p` [-].
template <class T>
TALUS_PORTABLE T find_relative_at(const WaterLaw& law, T p) {
  return lane_max(find_relative(law, material::find_water(law.retention, p)), T(lowest_relative_conductivity));
}
/// k_r of soil `k` at the nodes of T from `i` on, `full` without suction; zero where a node has none of it. Elements
/// take the mean over their nodes, so that a dry node does not block a wetting front.
template <class T>
TALUS_PORTABLE T find_relative_at_node(const auto& body, std::size_t k, double full, int i) {
  const auto& m = body.water.darcy;
  const auto has_soil = load_unaligned<T>(&m.node_pores[k][i]) > T(0.0);
  const T p = select(has_soil, load_unaligned<T>(&m.pressure[i]), T(0.0));
  const T relative = any(p > T(0.0)) ? find_relative_at(body.water.laws[k], p) : T(full);
  return select(has_soil, relative, T(0.0));
}

/// Constrained modulus E_c of the first point of element `e` [Pa].
template <class B>
TALUS_PORTABLE double find_modulus_of(const B& body, int e) {
  using P = PointFields<B::dimension>;
  constexpr int width = B::width;
  const std::int64_t slot = body.points.block_start[e / width];
  const double* p = body.points.slot(slot) + e % width;
  const int soil = body.points.material[body.points.id[static_cast<std::size_t>(slot * width + e % width)]];
  double sigma[P::stress_size], state[material::max_state_size];
  for (int i = 0; i < P::stress_size; ++i) sigma[i] = p[(P::stress + i) * width];
  for (int i = 0; i < count_states(body.laws, soil); ++i) state[i] = p[(P::state + i) * width];
  return find_modulus(body.laws, soil, sigma, state);
}

/// The same for the wet elements of T from `e` on; undefined for others.
template <class T, class B>
TALUS_PORTABLE T find_moduli(const B& body, int e, MaskOf<T> wet) {
  if constexpr (LaneTraits<T>::width == 1) {
    return wet ? find_modulus_of(body, e) : 1.0;
  } else {
    const unsigned soils = body.points.block_materials[static_cast<std::size_t>(e / B::width)];
    if (std::popcount(soils) == 1)
      if (const auto modulus = material::find_constant_modulus(body.laws[std::countr_zero(soils)])) return T(*modulus);
    T modulus(1.0);
    for (int l = 0; l < B::width; ++l)
      if (wet[l]) set_lane(modulus, l, find_modulus_of(body, e + l));
    return modulus;
  }
}

/// Coefficients of the flow through the elements of T from `e` on. `relative`: k_r, [material][node].
template <class T, class B, class Relative>
TALUS_PORTABLE void find_flow_through(B& body, const StepOptions<B::dimension>& o, const Relative& relative, int e) {
  auto& water = body.water;
  auto& m = water.darcy;
  const MaskOf<T> wet = load_unaligned<T>(&water.volume[e]) > T(0.0);
  T saturated(0.0), effective(0.0), coupling(0.0), conductive(0.0), soft(0.0), pressing(0.0);
  if (any(wet)) {
    const T p = select(wet, find_mean_of_nodes<T>(body, m.pressure, e), T(0.0));
    const bool drains = any(p > T(0.0));
    T volume(0.0);
    for (std::size_t k = 0; k < water.laws.size(); ++k) {
      const T v = load_unaligned<T>(&m.volume[k][e]);
      if (!any(v > T(0.0))) continue;
      const WaterLaw& law = water.laws[k];
      const T s = drains ? material::saturation(law.retention, p) : T(law.full), chi = find_chi(law, p, s),
              k_r = find_mean_of_nodes<T>(body, relative[k], e);
      volume += v;
      saturated += v * s;
      effective += v * chi;
      coupling += v * lane_sqrt(s * chi);
      conductive += v * (k_r * (1 / find_saturated_resistance(law, o.conductivity_factor)));
    }
    soft = 2.0 * volume / find_moduli<T>(body, e, wet);
    pressing = effective * p;
    store_unaligned(&water.mean_saturation[e],
                    select(wet, saturated / volume, load_unaligned<T>(&water.mean_saturation[e])));
    store_unaligned(&water.mean_pressure[e], select(wet, p, load_unaligned<T>(&water.mean_pressure[e])));
  }
  store_unaligned(&m.saturated[e], saturated);
  store_unaligned(&m.effective[e], effective);
  store_unaligned(&m.coupling[e], coupling);
  store_unaligned(&m.conductive[e], conductive);
  store_unaligned(&m.soft[e], select(wet, soft, T(0.0)));
  store_unaligned(&m.pressing[e], pressing);
}

/// The first row of the sums of node `i`, where the pressure forces are added and which the next pass zeroes; nullptr:
/// none.
template <int D>
double* find_row_to_press(Body<D>& body, int i) {
  const Layout<D>& layout = *body.layout;
  if (layout.row_start[i] == layout.row_start[i + 1]) return nullptr;
  return &body.nodes.sums[static_cast<std::size_t>(layout.node_rows[layout.row_start[i]]) * sums_stride];
}

/// press_nodes() of the nodes of T from `i` on, with DarcyWater::pressing.
template <class T, class B>
TALUS_PORTABLE void press_nodes_at(B& body, int i) {
  constexpr int D = B::dimension, count = LaneTraits<T>::width;
  auto& m = body.water.darcy;
  const auto& graph = *m.graph;
  T sum[D] = {};
  for (int t = graph.touch_start[i], end = graph.template find_touch_end<T>(i); t < end; t += graph.touch_stride) {
    const T pressing = graph.template gather_element<T>(m.pressing, t);
    T b[D];
    graph.template load_gradient<T>(body.mesh(), t, b);
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) sum[d] -= pressing * b[d];
  }
  double force[D][count];
  for (int d = 0; d < D; ++d) store_unaligned(&force[d][0], sum[d]);
  for (int l = 0; l < count; ++l) {
    double* row = find_row_to_press(body, i + l);
    if (row == nullptr) continue;
    for (int d = 0; d < D; ++d) {
      row[1 + D + d] += force[d][l] - m.pore_force[i + l][d];
      m.pore_force[i + l][d] = force[d][l];
    }
  }
}

/// Power of the forces of the pore pressures at node `i` [W].
template <class B>
TALUS_PORTABLE double find_pore_power_at(const B& body, int i) {
  constexpr int D = B::dimension;
  const double* velocity =
      &body.nodes.motion[static_cast<std::size_t>(body.layout->motion_row(i, 0)) * motion_stride<D> + D];
  double power = 0;
  for (int d = 0; d < D; ++d) power += body.water.darcy.pore_force[i][d] * velocity[d];
  return power;
}

/// Writes Σ m N_k² of the points of the elements of T from `e` on, by corner, from their moments [kg] (T22.3).
template <class T, class B>
TALUS_KERNEL void find_own_mass(const B& body, int e, auto& own_mass) {
  constexpr int D = B::dimension, width = B::width;
  const double* moments =
      &body.elements
           .moments[static_cast<std::size_t>(e / width) * moment_size<D> * width + static_cast<std::size_t>(e % width)];
  const MaskOf<T> has_points = load_unaligned<T>(&body.points.count[e]) > T(0.0);
  T first = load_unaligned<T>(moments);  // Σ m (1 - Σ ξ_k)²
  int at = 1 + D;
  TALUS_UNROLL
  for (int k = 0; k < D; ++k) {
    first -= 2.0 * load_unaligned<T>(moments + (1 + k) * width);
    TALUS_UNROLL
    for (int j = k; j < D; ++j, ++at) {
      const T second = load_unaligned<T>(moments + at * width);
      first += (j == k ? 1.0 : 2.0) * second;
      if (j == k)
        store_unaligned(&own_mass[body.water.darcy.graph->find_corner(e, k + 1)], select(has_points, second, T(0.0)));
    }
  }
  store_unaligned(&own_mass[body.water.darcy.graph->find_corner(e, 0)], select(has_points, first, T(0.0)));
}

/// predict_motion() of node `i`, of whose elements' points Σ m N_i² is `own`.
template <class B>
TALUS_PORTABLE void predict_node(B& body, const StepOptions<B::dimension>& o, double own, int i) {
  constexpr int D = B::dimension;
  auto& m = body.water.darcy;
  const auto& layout = *body.layout;
  const int* rows = &layout.node_rows[static_cast<std::size_t>(layout.row_start[i])];
  double t[1 + D];
  sum_rows<1 + D, sums_stride>(body.nodes.sums, rows, layout.row_start[i + 1] - layout.row_start[i], t);
  m.mobility[i] = 0;
  m.velocity[i] = m.acceleration[i] = Vec<D>{};
  if (!(t[0] > 1e-12 * body.smallest_mass)) return;
  const double inverse = 1 / t[0], seen = std::min(1.0, 0.5 * (D + 2) * own * inverse);
  m.mobility[i] = seen * o.dt * o.dt / o.mass_scaling * inverse;
  const double* a = &body.nodes.motion[static_cast<std::size_t>(layout.motion_row(i, 0)) * motion_stride<D>];
  for (int d = 0; d < D; ++d) {
    m.acceleration[i][d] = seen * a[d];
    m.velocity[i][d] = t[1 + d] * inverse + o.dt * seen * a[d];
  }
  if (const int c = body.conditions.constraint_of_node[i]; c >= 0)
    m.velocity[i] = constrain_remapped(body.conditions, c, m.velocity[i], body.time + o.dt);
}
/// predict_motion() of the nodes of T from `i` on. `own_mass`: find_own_mass() of the elements, by corner.
template <class T, class B>
TALUS_PORTABLE void predict_nodes(B& body, const StepOptions<B::dimension>& o, const auto& own_mass, int i) {
  const auto& graph = *body.water.darcy.graph;
  T own(0.0);
  for (int t = graph.touch_start[i], end = graph.template find_touch_end<T>(i); t < end; t += graph.touch_stride)
    own += select(graph.template are_touches<T>(i, t), graph.template gather_corner<T>(own_mass, t), T(0.0));
  double of_node[LaneTraits<T>::width];
  store_unaligned(&of_node[0], own);
  for (int l = 0; l < LaneTraits<T>::width; ++l) predict_node(body, o, of_node[l], i + l);
}

}  // namespace talus::mpm
