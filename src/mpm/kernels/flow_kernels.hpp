// SPDX-License-Identifier: MIT
#pragma once
// Kernels of the Darcy step before the solution of the pressures: contents of elements and nodes (T22.2), coefficients
// of the flow, forces of the pressures and predicted motion (T22.3), for a body B here or on a GPU.

#include <algorithm>
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
  for (std::size_t k = 0; k < materials; ++k) m.volume[k][e] *= water.stretch[e];
  water.volume[e] = wet;
  return wet > 0;
}

/// Contents of node `i` (T22.2), and the pressure that the step starts from. In the `first` step the pressure is given,
/// and o_i follows from it.
template <class B>
TALUS_PORTABLE void start_node(B& body, int i, bool first) {
  constexpr int D = B::dimension;
  auto& water = body.water;
  auto& m = water.darcy;
  const auto& graph = *m.graph;
  for (std::size_t k = 0; k < m.node_pores.size(); ++k) m.node_pores[k][i] = 0;
  double content = 0, all = 0, last = 0;
  for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t) {
    const int e = graph.element[t];
    if (!(water.volume[e] > 0)) continue;
    double here = 0;
    for (std::size_t k = 0; k < m.pores.size(); ++k) {
      const double pores = m.pores[k][e] / (D + 1);
      m.node_pores[k][i] += pores;
      here += pores;
    }
    content += m.water[e] / (D + 1);
    last += here * water.mean_pressure[e];
    all += here;
  }
  double& p = m.pressure[i];
  if (!(all > 0)) {
    p = NAN;
    m.node_water[i] = m.own[i] = 0;
    return;
  }
  const HeldWater held(water.laws, m.node_pores, i);
  if (first && !std::isnan(p)) m.own[i] = HeldLine::start(held, p).at(p) - content;
  m.own[i] = std::clamp(m.own[i], -most_own * content, most_own * content);
  content += m.own[i];
  m.node_water[i] = content;
  if (std::isnan(p)) p = last / all;
  if (!held.drains()) return;
  p = p > 0 && content < held.find_full().held ? held.find_suction(content, p) : std::min(p, 0.0);
}

// Coefficients of the flow, forces of the pressures and predicted motion, element by element and node by node.

/// k_r of soil `k` at the nodes of T from `i` on; zero where a node has none of it. Elements take the mean over their
/// nodes, so that a dry node does not block a wetting front.
template <class T>
TALUS_PORTABLE T find_relative_at_node(const auto& body, std::size_t k, int i) {
  const auto& m = body.water.darcy;
  const WaterLaw& law = body.water.laws[k];
  const auto has_soil = load_unaligned<T>(&m.node_pores[k][i]) > T(0.0);
  const T p = select(has_soil, load_unaligned<T>(&m.pressure[i]), T(0.0));
  const T relative = find_relative(law, material::find_water(law.retention, p));
  return select(has_soil, lane_max(relative, T(lowest_relative_conductivity)), T(0.0));
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

/// Coefficients of the flow through element `e`. `relative`: k_r, [material][node].
template <class B, class Relative>
TALUS_PORTABLE void find_flow_through(B& body, const StepOptions<B::dimension>& o, const Relative& relative, int e) {
  constexpr int D = B::dimension;
  auto& water = body.water;
  auto& m = water.darcy;
  const auto& mesh = body.mesh();
  m.saturated[e] = m.effective[e] = m.coupling[e] = m.conductive[e] = m.soft[e] = 0;
  if (!(water.volume[e] > 0)) return;
  double p = 0, volume = 0;
  for (int node : mesh.elements[e]) p += m.pressure[node] / (D + 1);
  for (std::size_t k = 0; k < water.laws.size(); ++k) {
    const double v = m.volume[k][e];
    if (!(v > 0)) continue;
    const WaterLaw& law = water.laws[k];
    const double s = material::saturation(law.retention, p), chi = find_chi(law, p, s);
    double k_r = 0;
    for (int node : mesh.elements[e]) k_r += relative[k][node] / (D + 1);
    volume += v;
    m.saturated[e] += v * s;
    m.effective[e] += v * chi;
    m.coupling[e] += v * std::sqrt(s * chi);
    m.conductive[e] += v * k_r / find_saturated_resistance(law, o.conductivity_factor);
  }
  m.soft[e] = 2 * volume / find_modulus_of(body, e);
  water.mean_saturation[e] = m.saturated[e] / volume;
  water.mean_pressure[e] = p;
}

/// The first row of the sums of node `i`, where the pressure forces are added and which the next pass zeroes; nullptr:
/// none.
template <int D>
double* find_row_to_press(Body<D>& body, int i) {
  const Layout<D>& layout = *body.layout;
  if (layout.row_start[i] == layout.row_start[i + 1]) return nullptr;
  return &body.nodes.sums[static_cast<std::size_t>(layout.node_rows[layout.row_start[i]]) * sums_stride];
}

/// press_nodes() of node `i`, with the mean pressures of the elements.
template <class B>
TALUS_PORTABLE void press_node(B& body, int i) {
  constexpr int D = B::dimension;
  auto& m = body.water.darcy;
  const auto& mesh = body.mesh();
  const auto& graph = *m.graph;
  Vec<D> force{};
  for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t) {
    const int e = graph.element[t];
    if (!(body.water.volume[e] > 0)) continue;
    const double stress = m.effective[e] * body.water.mean_pressure[e];
    const Vec<D> gradient = mesh::find_shape_gradient(mesh, e, graph.local[t]);
    for (int d = 0; d < D; ++d) force[d] -= stress * gradient[d];
  }
  double* row = find_row_to_press(body, i);
  if (row == nullptr) return;
  for (int d = 0; d < D; ++d) row[1 + D + d] += force[d] - m.pore_force[i][d];
  m.pore_force[i] = force;
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

/// Σ m N_k² of the points of element `e` for its local nodes, from its moments [kg] (T22.3).
template <class B>
TALUS_PORTABLE auto find_own_mass(const B& body, int e) {
  constexpr int D = B::dimension, width = B::width;
  std::array<double, D + 1> own{};
  if (!(body.points.count[e] > 0)) return own;
  const double* moments =
      &body.elements
           .moments[static_cast<std::size_t>(e / width) * moment_size<D> * width + static_cast<std::size_t>(e % width)];
  double m[moment_size<D>];
  for (int q = 0; q < moment_size<D>; ++q) m[q] = moments[q * width];
  for (int k = 0; k <= D; ++k) {
    double unit[D + 1][D] = {}, out[D + 1][D];
    unit[k][0] = 1;
    remap_element<D, double>(m, unit, 1, out);
    own[static_cast<std::size_t>(k)] = out[k][0];
  }
  return own;
}

/// predict_motion() of node `i`. `own_mass`: find_own_mass() of the elements.
template <class B, class OwnMass>
TALUS_PORTABLE void predict_node(B& body, const StepOptions<B::dimension>& o, const OwnMass& own_mass, int i) {
  constexpr int D = B::dimension;
  auto& m = body.water.darcy;
  const auto& layout = *body.layout;
  const auto& graph = *m.graph;
  const int* rows = &layout.node_rows[static_cast<std::size_t>(layout.row_start[i])];
  double t[1 + D];
  sum_rows<1 + D, sums_stride>(body.nodes.sums, rows, layout.row_start[i + 1] - layout.row_start[i], t);
  m.mobility[i] = 0;
  m.velocity[i] = m.acceleration[i] = Vec<D>{};
  if (!(t[0] > 1e-12 * body.smallest_mass)) return;
  double own = 0;
  for (int n = graph.touch_start[i]; n < graph.touch_start[i + 1]; ++n)
    own += own_mass[graph.element[n]][static_cast<std::size_t>(graph.local[n])];
  const double seen = std::min(1.0, 0.5 * (D + 2) * own / t[0]);
  m.mobility[i] = seen * o.dt * o.dt / (o.mass_scaling * t[0]);
  const double* a = &body.nodes.motion[static_cast<std::size_t>(layout.motion_row(i, 0)) * motion_stride<D>];
  for (int d = 0; d < D; ++d) {
    m.acceleration[i][d] = seen * a[d];
    m.velocity[i][d] = t[1 + d] / t[0] + o.dt * seen * a[d];
  }
  if (const int c = body.conditions.constraint_of_node[i]; c >= 0)
    m.velocity[i] = constrain_remapped(body.conditions, c, m.velocity[i], body.time + o.dt);
}

}  // namespace talus::mpm
