// SPDX-License-Identifier: MIT
// Coefficients of the flow in a step, the forces of the pressures, and the motion that they predict.

#include <cmath>

#include "mesh/shape_gradient.hpp"
#include "mpm/body/point_state.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/pore_state.hpp"
#include "mpm/mixture/mixture_step.hpp"
#include "mpm/mixture/sweep.hpp"
#include "mpm/step/kernels.hpp"

namespace talus::mpm {
namespace {

/// E_c of the first point of element `e` [Pa].
template <int D>
double find_modulus_of(const Body<D>& body, int e) {
  const std::int64_t slot = body.points.block_start[e / lane_width];
  const int id = body.points.id[static_cast<std::size_t>(slot * lane_width + e % lane_width)];
  return find_modulus<D>(body.laws[body.points.material[id]], body.points.slot(slot) + e % lane_width);
}

}  // namespace

template <int D>
void find_flow(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  MixtureWater<D>& m = water.mixture;
  const mesh::Mesh<D>& mesh = body.mesh();
  // k_r as the mean over the nodes: a dry one does not close the element to a front.
  std::vector<std::vector<double>> relative(water.laws.size());
  for (std::size_t k = 0; k < water.laws.size(); ++k) {
    if (!water.laws[k].wet) continue;
    relative[k].resize(mesh.nodes.size());
    for_nodes(body, o.threads, [&, k](int i) {
      if (m.node_pores[k][i] > 0)
        relative[k][i] = find_state_at_pressure<double>(water.laws[k], m.pressure[i]).relative;
    });
    update_nodes(body, relative[k]);
  }
  for_elements(body, o.threads, [&](int e) {
    m.saturated[e] = m.effective[e] = m.coupling[e] = m.conductive[e] = m.soft[e] = 0;
    if (!(water.volume[e] > 0)) return;
    double p = 0, volume = 0;
    for (int node : mesh.elements[e]) p += m.pressure[node] / (D + 1);
    for (std::size_t k = 0; k < water.laws.size(); ++k) {
      const double v = m.volume[k][e];
      if (!(v > 0)) continue;
      const WaterLaw& law = water.laws[k];
      const double s = find_state_at_pressure<double>(law, p).saturation, chi = find_chi(law, p, s);
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
  });
  update_elements(body, m.saturated, m.effective, m.coupling, m.conductive, m.soft);
}

template <int D>
void load_mixture(Body<D>& body, const StepOptions<D>& o) {
  gather_loads(body);
  if (body.nodes.load.empty()) body.nodes.load.assign(body.mesh().nodes.size(), Vec<D>{});
  if (body.water.mixture_load.empty()) return;
  for_node_pieces(body, o.threads, [&](int begin, int end, int) {
    for (int i = begin; i < end; ++i)
      for (int d = 0; d < D; ++d) body.nodes.load[i][d] += body.water.mixture_load[i][d];
  });
}

template <int D>
void press_nodes(Body<D>& body, const StepOptions<D>& o) {
  MixtureWater<D>& m = body.water.mixture;
  const mesh::Mesh<D>& mesh = body.mesh();
  const Layout<D>& layout = *body.layout;
  const NodeGraph<D>& graph = *m.graph;
  for_nodes(body, o.threads, [&](int i) {
    Vec<D> force{};
    for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t) {
      const int e = graph.element[t];
      if (!(body.water.volume[e] > 0)) continue;
      double p = 0;
      for (int node : mesh.elements[e]) p += m.pressure[node] / (D + 1);
      const Vec<D> gradient = mesh::find_shape_gradient(mesh, e, graph.local[t]);
      for (int d = 0; d < D; ++d) force[d] -= m.effective[e] * p * gradient[d];
    }
    if (layout.row_start[i] == layout.row_start[i + 1]) return;
    double* row = &body.nodes.sums[static_cast<std::size_t>(layout.node_rows[layout.row_start[i]]) * sums_stride];
    for (int d = 0; d < D; ++d) row[1 + D + d] += force[d] - m.pore_force[i][d];
    m.pore_force[i] = force;
  });
}

template <int D>
double find_pore_power(const Body<D>& body, const StepOptions<D>& o) {
  const Layout<D>& layout = *body.layout;
  const auto has_rows = [&](int i) { return layout.row_start[i] < layout.row_start[i + 1]; };
  return list_nodes(body, has_rows).sum(body, o.threads, [&](int i) {
    const double* velocity =
        &body.nodes.motion[static_cast<std::size_t>(layout.node_rows[layout.row_start[i]]) * motion_stride<D> + D];
    double power = 0;
    for (int d = 0; d < D; ++d) power += body.water.mixture.pore_force[i][d] * velocity[d];
    return power;
  });
}

/// Σ m N_k² of the points of element `e` for its local nodes, from its moments [kg].
template <int D>
std::array<double, D + 1> find_own_mass(const Body<D>& body, int e) {
  const double* moments =
      &body.elements.moments[static_cast<std::size_t>(e / lane_width) * moment_size<D> * lane_width +
                             static_cast<std::size_t>(e % lane_width)];
  double m[moment_size<D>];
  for (int q = 0; q < moment_size<D>; ++q) m[q] = moments[q * lane_width];
  std::array<double, D + 1> own;
  for (int k = 0; k <= D; ++k) {
    double unit[D + 1][D] = {}, out[D + 1][D];
    unit[k][0] = 1;
    remap_element<D, double>(m, unit, 1, out);
    own[static_cast<std::size_t>(k)] = out[k][0];
  }
  return own;
}

/// Whether walls are pressed on, at nodes that other ranks sum up.
template <int D>
void update_pressed(Body<D>& body) {
  Conditions<D>& conditions = body.conditions;
  if (!body.share || conditions.pressed.empty()) return;
  std::vector<double> pressed(body.mesh().nodes.size(), 0.0);
  const auto for_constraints = [&](auto&& work) {
    for (std::size_t i = 0; i < pressed.size(); ++i)
      if (const int c = conditions.constraint_of_node[i]; c >= 0)
        work(pressed[i], conditions.pressed[static_cast<std::size_t>(c)]);
  };
  for_constraints([](double& of_node, std::uint8_t& of_wall) { of_node = of_wall; });
  update_nodes(body, pressed);
  for_constraints([](double& of_node, std::uint8_t& of_wall) { of_wall = of_node != 0; });
}

template <int D>
void predict_motion(Body<D>& body, const StepOptions<D>& o) {
  MixtureWater<D>& m = body.water.mixture;
  const Layout<D>& layout = *body.layout;
  const NodeGraph<D>& graph = *m.graph;
  const double cutoff = 1e-12 * body.smallest_mass;
  std::vector<std::array<double, D + 1>> own_mass(body.mesh().elements.size());
  for_elements(body, o.threads, [&](int e) {
    own_mass[e] = body.points.count[e] > 0 ? find_own_mass(body, e) : std::array<double, D + 1>{};
  });
  update_elements(body, own_mass);
  for_nodes(body, o.threads, [&](int i) {
    const int* rows = &layout.node_rows[static_cast<std::size_t>(layout.row_start[i])];
    double t[1 + D];
    sum_rows<1 + D, sums_stride>(body.nodes.sums, rows, layout.row_start[i + 1] - layout.row_start[i], t);
    m.mobility[i] = 0;
    m.velocity[i] = m.acceleration[i] = {};
    if (!(t[0] > cutoff)) return;
    double own = 0;
    for (int n = graph.touch_start[i]; n < graph.touch_start[i + 1]; ++n)
      own += own_mass[graph.element[n]][graph.local[n]];
    const double seen = std::min(1.0, 0.5 * (D + 2) * own / t[0]);
    m.mobility[i] = seen * o.dt * o.dt / (o.mass_scaling * t[0]);
    const double* a = &body.nodes.motion[static_cast<std::size_t>(rows[0]) * motion_stride<D>];
    for (int d = 0; d < D; ++d) {
      m.acceleration[i][d] = seen * a[d];
      m.velocity[i][d] = t[1 + d] / t[0] + o.dt * seen * a[d];
    }
    if (const int c = body.conditions.constraint_of_node[i]; c >= 0)
      m.velocity[i] = constrain_remapped(body.conditions, c, m.velocity[i], body.time + o.dt);
  });
  update_nodes(body, m.velocity, m.acceleration, m.mobility);
  update_pressed(body);
}

#define TALUS_INSTANTIATE(D)                                                 \
  template void find_flow<D>(Body<D>&, const StepOptions<D>&);               \
  template void load_mixture<D>(Body<D>&, const StepOptions<D>&);            \
  template void press_nodes<D>(Body<D>&, const StepOptions<D>&);             \
  template double find_pore_power<D>(const Body<D>&, const StepOptions<D>&); \
  template void predict_motion<D>(Body<D>&, const StepOptions<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
