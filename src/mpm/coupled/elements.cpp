// SPDX-License-Identifier: MIT
// Single elements of the coupled step, from their points: for those that relocation touches, and for a fresh start.

#include "mpm/coupled/coupled_step.hpp"
#include "mpm/coupled/kernels.hpp"
#include "mpm/coupled/pore_state.hpp"

namespace talus::mpm {
namespace {

/// Pointer to field 0 of the k-th point of element `e`, and its material.
template <int D>
double* find_point(Body<D>& body, int e, int k) {
  return body.points.slot(body.points.block_start[e / lane_width] + k) + e % lane_width;
}
template <int D>
int find_point_material(const Body<D>& body, int e, int k) {
  const std::int64_t slot = body.points.block_start[e / lane_width] + k;
  return body.points.material[body.points.id[static_cast<std::size_t>(slot * lane_width + e % lane_width)]];
}

}  // namespace

template <int D>
void add_wet_element(Body<D>& body, int e, const StepOptions<D>& o, double sign) {
  using P = Points<D>;
  using W = WaterFields<D>;
  using C = WetColumns<D>;
  Water<D>& water = body.water;
  ElementSums<D, double> sums;
  WaterSums<D, double> water_sums;
  const int n = static_cast<int>(body.points.count[e]);
  for (int k = 0; k < n; ++k) {
    const double* p = find_point(body, e, k);
    const double* w = p + water.first_field * lane_width;
    const WaterLaw& law = water.laws[find_point_material(body, e, k)];
    double xi[D], u[D], uw[D], stress[P::stress_size];
    for (int d = 0; d < D; ++d) {
      xi[d] = p[(P::xi + d) * lane_width];
      u[d] = p[(P::velocity + d) * lane_width];
      uw[d] = w[(W::velocity + d) * lane_width];
    }
    const double volume = p[P::volume * lane_width];
    PoreState<double> pore{};
    double resistance = 0;
    if (law.wet) {
      resistance = find_saturated_resistance(law, o.conductivity_factor);
      pore = find_state_at_pressure<double>(law, w[W::pressure * lane_width]);
    }
    for (int i = 0; i < P::stress_size; ++i) {
      stress[i] = p[(P::stress + i) * lane_width];
      if (i < D) stress[i] += pore.bishop;
    }
    sums.add(p[P::mass * lane_width], volume, xi, u, stress);
    water_sums.add({w[W::mass * lane_width], law.wet ? volume : 0.0, pore.pressure, pore.bishop, pore.saturation,
                    resistance, pore.relative},
                   xi, uw);
  }
  const std::size_t block = static_cast<std::size_t>(e / lane_width), lane = static_cast<std::size_t>(e % lane_width);
  double g[D * D], solid[D + 1][1 + 2 * D], out[D + 1][C::count];
  for (std::size_t i = 0; i < D * D; ++i) g[i] = body.mesh().gradients[e][i];
  for (double& s : sums.stress) s *= water.stretch[e];
  sums.to_nodes(g, solid);
  copy_solid_columns<D>(solid, out);
  water_sums.to_nodes(g, water.stretch[e], out);
  for (std::size_t k = 0; k <= D; ++k) {
    const int row = body.layout->connectivity[(block * (D + 1) + k) * lane_width + lane];
    double* target = &water.sums[static_cast<std::size_t>(row) * wet_sums_stride<D>];
    for (int c = 0; c < C::count; ++c) target[c] += sign * out[k][c];
  }
  if (sign < 0) return;
  const double volume = water_sums.volume[0];
  water.volume[e] = volume;
  water.mean_saturation[e] = volume > 0 ? water_sums.saturation / volume : 0.0;
  water.mean_pressure[e] = volume > 0 ? water_sums.pressure / volume : 0.0;
  water.mean_bishop[e] = volume > 0 ? water_sums.bishop / volume : 0.0;
  water.mean_resistance[e] = volume > 0 ? water_sums.resistance[0] / water_sums.relative[0] : 0.0;
  for (std::size_t i = 0; i < moment_size<D>; ++i) {
    const std::size_t at = (block * moment_size<D> + i) * lane_width + lane;
    body.elements.moments[at] = sums.moments[i];
    water.moments[at] = water_sums.moments[i];
  }
}

template <int D>
void share_wet_element(Body<D>& body, int e, const StepOptions<D>& o) {
  using P = Points<D>;
  using W = WaterFields<D>;
  Water<D>& water = body.water;
  const int n = static_cast<int>(body.points.count[e]);
  water.stretch[e] = 1;
  if (!o.mixed || n == 0) return;
  double volume = 0, grains = 0, mass = 0, pressure = 0;
  for (int k = 0; k < n; ++k) {
    if (find_point_material(body, e, k) != find_point_material(body, e, 0)) return;
    const double* p = find_point(body, e, k);
    const double* w = p + water.first_field * lane_width;
    volume += p[P::volume * lane_width];
    grains += p[P::mass * lane_width];
    mass += w[W::mass * lane_width];
    pressure += w[W::pressure * lane_width] * p[P::volume * lane_width];
  }
  if (!(volume > body.elements.fill_limit[e])) return;
  water.stretch[e] = body.mesh().volumes[e] / volume;
  const WaterLaw& law = water.laws[find_point_material(body, e, 0)];
  if (!law.wet || n == 1) return;
  const double per_pores = mass / (volume - grains / law.grain_density);
  const PoreState<double> shared = find_pore_state<double>(law, per_pores / law.density, pressure / volume, true);
  for (int k = 0; k < n; ++k) {
    double* p = find_point(body, e, k);
    double* w = p + water.first_field * lane_width;
    w[W::mass * lane_width] = per_pores * (p[P::volume * lane_width] - p[P::mass * lane_width] / law.grain_density);
    w[W::pressure * lane_width] = shared.pressure;
    w[W::capacity * lane_width] = shared.capacity;
  }
}

template <int D>
std::vector<Vec<D>> find_pore_force(Body<D>& body, const StepOptions<D>& o) {
  using P = Points<D>;
  load_surface(body, o);
  const mesh::Mesh<D>& mesh = body.mesh();
  std::vector<Vec<D>> force = body.water.darcy_load;
  force.resize(mesh.nodes.size(), Vec<D>{});
  for (int e = 0; e < mesh.element_count(); ++e) {
    double total = 0;
    for (int k = 0; k < static_cast<int>(body.points.count[e]); ++k) {
      const WaterLaw& law = body.water.laws[find_point_material(body, e, k)];
      if (!law.wet) continue;
      const double* p = find_point(body, e, k);
      const double pressure = p[(body.water.first_field + WaterFields<D>::pressure) * lane_width];
      total += p[P::volume * lane_width] * find_state_at_pressure<double>(law, pressure).bishop;
    }
    total *= body.water.stretch[e];
    const auto& g = mesh.gradients[e];
    for (int d = 0; d < D; ++d) {
      for (int k = 0; k < D; ++k) {
        const double f = total * g[static_cast<std::size_t>(k) * D + static_cast<std::size_t>(d)];
        force[mesh.elements[e][k + 1]][d] -= f;
        force[mesh.elements[e][0]][d] += f;
      }
    }
  }
  return force;
}

template std::vector<Vec<2>> find_pore_force<2>(Body<2>&, const StepOptions<2>&);
template std::vector<Vec<3>> find_pore_force<3>(Body<3>&, const StepOptions<3>&);
template void add_wet_element<2>(Body<2>&, int, const StepOptions<2>&, double);
template void add_wet_element<3>(Body<3>&, int, const StepOptions<3>&, double);
template void share_wet_element<2>(Body<2>&, int, const StepOptions<2>&);
template void share_wet_element<3>(Body<3>&, int, const StepOptions<3>&);

}  // namespace talus::mpm
