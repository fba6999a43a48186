// SPDX-License-Identifier: MIT
// Coefficients of the flow in a step, the forces of the pressures, and the motion that they predict.

#include <cmath>

#include "base/parallel.hpp"
#include "mesh/shape_gradient.hpp"
#include "mpm/body/node_rows.hpp"
#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/pore_state.hpp"
#include "mpm/mixture/mixture_step.hpp"

namespace talus::mpm {
namespace {

/// χ of Bishop's stress, see WaterLaw::chi_air_entry.
double find_chi(const WaterLaw& law, double pressure, double saturation) {
  if (law.chi_air_entry <= 0) return saturation;
  return pressure <= law.chi_air_entry ? 1.0 : std::pow(pressure / law.chi_air_entry, -0.55);
}

/// E_c of the first point of element `e` [Pa].
template <int D>
double find_modulus(const Body<D>& body, int e) {
  using P = Points<D>;
  const std::int64_t slot = body.points.block_start[e / lane_width];
  const double* p = body.points.slot(slot) + e % lane_width;
  const material::Law& law =
      body.laws[body.points.material[body.points.id[static_cast<std::size_t>(slot * lane_width + e % lane_width)]]];
  double sigma[P::stress_size], state[material::max_state_size];
  for (int i = 0; i < P::stress_size; ++i) sigma[i] = p[(P::stress + i) * lane_width];
  for (int i = 0; i < material::state_size(law); ++i) state[i] = p[(P::state + i) * lane_width];
  return material::constrained_modulus(law, sigma, state);
}

/// Calls work(first, end) for the elements of every chunk, in parallel.
template <int D, class Work>
void for_elements(const Body<D>& body, int threads, Work&& work) {
  const Layout<D>& layout = *body.layout;
  const int elements = body.mesh().element_count();
  parallel_for(layout.chunks, threads, [&](int c) {
    const int end = std::min(elements, layout.chunk_start[c + 1] * lane_width);
    for (int e = layout.chunk_start[c] * lane_width; e < end; ++e) work(e);
  });
}

template <int D, class Work>
void for_nodes(const Body<D>& body, int threads, Work&& work) {
  parallel_for(body.layout->chunks, threads, [&](int c) {
    for (int i = first_node(body, c); i < first_node(body, c + 1); ++i) work(i);
  });
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
    m.soft[e] = 2 * volume / find_modulus(body, e);
    water.mean_saturation[e] = m.saturated[e] / volume;
    water.mean_pressure[e] = p;
  });
}

template <int D>
void load_mixture(Body<D>& body, const StepOptions<D>& o, const std::vector<double>& pressure) {
  const MixtureWater<D>& m = body.water.mixture;
  const mesh::Mesh<D>& mesh = body.mesh();
  body.nodes.load.assign(mesh.nodes.size(), Vec<D>{});
  gather_loads(body);
  const NodeGraph<D>& graph = *m.graph;
  const bool outside = !body.water.mixture_load.empty();
  for_nodes(body, o.threads, [&](int i) {
    Vec<D>& load = body.nodes.load[i];
    for (int t = graph.touch_start[i]; t < graph.touch_start[i + 1]; ++t) {
      const int e = graph.element[t];
      if (!(body.water.volume[e] > 0)) continue;
      double p = 0;
      for (int node : mesh.elements[e]) p += pressure[node] / (D + 1);
      const Vec<D> gradient = mesh::find_shape_gradient(mesh, e, graph.local[t]);
      for (int d = 0; d < D; ++d) load[d] -= m.effective[e] * p * gradient[d];
    }
    for (int d = 0; d < D && outside; ++d) load[d] += body.water.mixture_load[i][d];
  });
}

template <int D>
void predict_motion(Body<D>& body, const StepOptions<D>& o) {
  MixtureWater<D>& m = body.water.mixture;
  const Layout<D>& layout = *body.layout;
  const double cutoff = 1e-12 * body.smallest_mass;
  for_nodes(body, o.threads, [&](int i) {
    const int* rows = &layout.node_rows[static_cast<std::size_t>(layout.row_start[i])];
    double t[1 + D];
    sum_rows<1 + D, sums_stride>(body.nodes.sums, rows, layout.row_start[i + 1] - layout.row_start[i], t);
    m.mobility[i] = 0;
    m.velocity[i] = m.acceleration[i] = {};
    if (!(t[0] > cutoff)) return;
    m.mobility[i] = o.dt * o.dt / (o.mass_scaling * t[0]);
    const double* a = &body.nodes.motion[static_cast<std::size_t>(rows[0]) * motion_stride<D>];
    for (int d = 0; d < D; ++d) {
      m.acceleration[i][d] = a[d];
      m.velocity[i][d] = t[1 + d] / t[0] + o.dt * a[d];
    }
  });
}

#define TALUS_INSTANTIATE(D)                                                                  \
  template void find_flow<D>(Body<D>&, const StepOptions<D>&);                                \
  template void load_mixture<D>(Body<D>&, const StepOptions<D>&, const std::vector<double>&); \
  template void predict_motion<D>(Body<D>&, const StepOptions<D>&);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
