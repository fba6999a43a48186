// SPDX-License-Identifier: MIT
// Single elements of the two-velocity step, exchange of water between neighbouring elements against spurious pressure
// modes (T14.9), and nodal averages of strain increment and seepage divergence (2.94, 2.96).
#include <algorithm>
#include <cmath>

#include "base/rows.hpp"
#include "mesh/mesh.hpp"
#include "mpm/kernels/averages.hpp"
#include "mpm/kernels/element_kernels.hpp"
#include "mpm/kernels/pore_state.hpp"
#include "mpm/state/partition.hpp"
#include "mpm/two_velocity/kernels.hpp"
#include "mpm/two_velocity/two_velocity_step.hpp"

namespace talus::mpm {

// Single elements of the two-velocity step, computed from their points: for relocation and for the start of a stage.

namespace {

/// Pointer to field 0 of the k-th point of element `e`; field i is i * lane_width behind it.
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
void average_wet_element(Body<D>& body, int e, const StepOptions<D>& o) {
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
template void average_wet_element<2>(Body<2>&, int, const StepOptions<2>&);
template void average_wet_element<3>(Body<3>&, int, const StepOptions<3>&);

namespace {

/// Largest fraction of the smaller storage that one exchange moves across a side, for stability. The storage is that of
/// saturated soil, so that an element that fills during the exchange does not receive the water that it could store
/// when it was drier.
constexpr double exchange_share = 0.05;

/// State of a full wet element that enters an exchange.
template <int D>
struct ExchangeElement {
  Vec<D> centre{};        ///< [m]
  double pressure = 0;    ///< [Pa]
  double resistance = 0;  ///< ρ_w g/k [N s/m⁴]
  double storage = 0;     ///< of its water alone, Σ m_w/(ρ_w K_w) [m³/Pa]
};

template <int D>
bool takes_part(const Body<D>& body, int e) {
  return e >= 0 && body.points.count[e] > 0 && body.water.volume[e] > full_share * body.mesh().volumes[e];
}

template <int D>
ExchangeElement<D> read_element(const Body<D>& body, int e, double storage) {
  const Water<D>& water = body.water;
  ExchangeElement<D> r{{}, water.mean_pressure[e], water.mean_resistance[e], storage};
  for (int i : body.mesh().elements[e]) {
    for (int d = 0; d < D; ++d) r.centre[d] += body.mesh().nodes[i][d] / (D + 1);
  }
  return r;
}

/// Volume of water [m³] that flows from `e` to its neighbour across the side opposite local node `k` until the next
/// exchange (T14.9).
template <int D>
double find_exchange(const Body<D>& body, const StepOptions<D>& o, int e, int k, const ExchangeElement<D>& from,
                     const ExchangeElement<D>& to) {
  const double density = body.water.density, dt = exchange_interval * o.dt;
  const mesh::Mesh<D>& mesh = body.mesh();
  Vec<D> middle{}, flux{};
  for (int i = 0; i <= D; ++i) {
    if (i == k) continue;
    const int node = mesh.elements[e][i];
    for (int d = 0; d < D; ++d) {
      middle[d] += mesh.nodes[node][d] / D;
      flux[d] += body.water.still_flux[node][d] / D;
    }
  }
  // Pressure difference between the centroids beyond the hydrostatic one, and the part of it that Darcy's law explains.
  double growth = to.pressure - from.pressure, explained = 0, first2 = 0, second2 = 0;
  for (int d = 0; d < D; ++d) {
    const double first = middle[d] - from.centre[d], second = to.centre[d] - middle[d];
    growth += density * o.gravity[d] * (first + second);
    explained += flux[d] * (from.resistance * first + to.resistance * second);
    first2 += first * first;
    second2 += second * second;
  }
  const double area = D * mesh.volumes[e] * norm(mesh::find_shape_gradient(mesh, e, k));
  const double conductance = area / (from.resistance * std::sqrt(first2) + to.resistance * std::sqrt(second2));
  const double most = exchange_share * std::min(from.storage, to.storage);
  // Only down the head, and not more than the whole head difference drives: at boundary layers that the mesh does not
  // resolve, the nodal fluxes explain too much.
  const double rest = growth - explained;
  if (rest * growth <= 0) return 0;
  return std::min(conductance * dt, most) * (std::abs(rest) < std::abs(growth) ? rest : growth);
}

}  // namespace

template <int D>
void exchange_water(Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  const mesh::Mesh<D>& mesh = body.mesh();
  const Layout<D>& layout = *body.layout;
  const double compressibility = 1 / (water.density * water.bulk_modulus);
  std::vector<double> storage(mesh.elements.size());
  for_chunks(body, o.threads, [&](int c) {
    const int end = std::min(layout.chunk_start[c + 1] * lane_width, mesh.element_count());
    for (int e = layout.chunk_start[c] * lane_width; e < end; ++e)
      storage[e] =
          compressibility * water.moments[static_cast<std::size_t>(e / lane_width) * moment_size<D> * lane_width +
                                          static_cast<std::size_t>(e % lane_width)];
  });
  update_elements(body, storage, water.mean_pressure, water.mean_resistance, water.volume);
  if (!o.smooth_pressure) std::fill(water.surplus.begin(), water.surplus.end(), 0.0);
  // Each element computes the flow across all its sides itself. Both elements of a side compute the same value,
  // whatever the order.
  for_chunks(body, o.threads, [&](int c) {
    const int end = std::min(layout.chunk_start[c + 1] * lane_width, mesh.element_count());
    for (int e = layout.chunk_start[c] * lane_width; e < end; ++e) {
      if (!takes_part(body, e)) continue;
      const ExchangeElement<D> mine = read_element(body, e, storage[e]);
      double lost = 0;
      for (int k = 0; k <= D; ++k) {
        const int n = mesh.neighbours[e][k];
        if (!takes_part(body, n)) continue;
        lost += find_exchange(body, o, e, k, mine, read_element(body, n, storage[n]));
      }
      water.surplus[e] += lost / water.volume[e];
    }
  });
}

template void exchange_water<2>(Body<2>&, const StepOptions<2>&);
template void exchange_water<3>(Body<3>&, const StepOptions<3>&);

// Nodal averages of the volumetric strain increment with weights V_e and of the divergence of the seepage with weights
// V̄ (2.94), and the surplus of pressure smoothing (2.96, T14.8).

namespace {

constexpr int columns = 4;  ///< of a row of Water::average: value and weight, twice

/// Volumetric strain increment of a block, and Δt times the divergence of its seepage.
template <int D>
std::pair<Pack, Pack> find_increments(const Body<D>& body, int b, const int* rows, double dt) {
  Pack strain(0.0), divergence(0.0), first[4 * D];
  const double* g = &body.layout->gradients[static_cast<std::size_t>(b) * D * D * lane_width];
  load_rows<4 * D, wet_motion_stride<D>>(body.water.motion.data(), rows, first);
  TALUS_UNROLL
  for (int k = 0; k < D; ++k) {
    Pack motion[4 * D];
    load_rows<4 * D, wet_motion_stride<D>>(body.water.motion.data(), rows + (k + 1) * lane_width, motion);
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) {
      const Pack gradient = load<Pack>(g + (k * D + d) * lane_width);
      strain += (motion[2 * D + d] - first[2 * D + d]) * gradient;
      divergence += (motion[3 * D + d] - first[3 * D + d]) * gradient;
    }
  }
  return {strain * dt, divergence * dt};
}

}  // namespace

template <int D>
void smooth_increments(Wet, Body<D>& body, const StepOptions<D>& o) {
  Water<D>& water = body.water;
  const bool strains = o.smoothing != input::Smoothing::none, stable = o.smoothing == input::Smoothing::stable;
  if (strains) {
    for_blocks_and_update(body, o.threads, water.average, columns, [&](int b, const int* rows) {
      const std::size_t first = static_cast<std::size_t>(b) * lane_width;
      const Mask active = load<Pack>(&body.points.count[first]) > Pack(0.0);
      const Pack V_e = select(takes_part(body, first), load<Pack>(&body.layout->volumes[first]), Pack(0.0));
      const Pack wet = select(active, load<Pack>(&water.volume[first]) * load<Pack>(&water.stretch[first]), Pack(0.0));
      auto [strain, divergence] = find_increments(body, b, rows, o.dt);
      if (stable) strain -= load<Pack>(&body.elements.plastic_dilation[first]);
      add_average<D>(water.average, rows,
                     {V_e * select(active, strain, Pack(0.0)), V_e, wet * select(active, divergence, Pack(0.0)), wet});
    });
    divide_averages<columns, columns>(body, o.threads, water.average, water.smoothed.data());
  }
  if (!o.smooth_pressure) return;
  // Δζ_e of (T14.8); `surplus` stores it until its average is known.
  for_blocks(body, o.threads, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    auto [strain, divergence] = find_increments(body, b, rows, o.dt);
    if (strains) {
      Pack smooth = find_node_mean<Body<D>, columns>(water.smoothed.data(), rows), rough;
      if (stable) smooth = join_dilation(body, first, strain, smooth, rough);
      strain = select(is_apart(body, first), strain, smooth);
      divergence = find_node_mean<Body<D>, columns>(water.smoothed.data() + 1, rows);
    }
    store(&water.surplus[first],
          load<Pack>(&water.stretch[first]) * (load<Pack>(&water.mean_saturation[first]) * strain + divergence));
  });
  for_blocks_and_update(body, o.threads, water.average, columns, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    const Mask active = load<Pack>(&body.points.count[first]) > Pack(0.0);
    const Pack volume = select(active, load<Pack>(&water.volume[first]), Pack(0.0));
    const Pack value = select(active, load<Pack>(&water.surplus[first]), Pack(0.0));
    add_average<D>(water.average, rows, {Pack(0.0), Pack(0.0), volume * value, volume});
  });
  divide_averages<columns, columns>(body, o.threads, water.average, water.smoothed.data() + 2);
  for_blocks(body, o.threads, [&](int b, const int* rows) {
    const std::size_t first = static_cast<std::size_t>(b) * lane_width;
    store(&water.surplus[first],
          find_node_mean<Body<D>, columns>(water.smoothed.data() + 3, rows) - load<Pack>(&water.surplus[first]));
  });
}

template void smooth_increments<2>(Wet, Body<2>&, const StepOptions<2>&);
template void smooth_increments<3>(Wet, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
