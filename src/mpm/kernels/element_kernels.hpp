// SPDX-License-Identifier: MIT
#pragma once
// Internal force, free surface, point sums and critical step of single elements, for relocation and for the start of a
// stage, and the averages of volumetric strain of a block. B is a Body or the body on a GPU.

#include <cmath>

#include "base/rows.hpp"
#include "mpm/kernels/averages.hpp"
#include "mpm/kernels/laws.hpp"
#include "mpm/kernels/point_kernels.hpp"
#include "mpm/state/body.hpp"

namespace talus::mpm {

/// Fraction of V_e above which an element at the free surface counts as full (2.92).
inline constexpr double full_share = 0.9;

/// Adds `sign` times the internal force of element `e`, from the points that it holds now, to its node rows.
template <class B>
TALUS_PORTABLE void add_internal_force(B& body, int e, bool mixed, double sign);

/// Sets elements.fill_limit of `e`: full_share·V_e at the free surface (a neighbour holds no point), else 0 [m³].
/// Returns whether it changed.
template <class B>
TALUS_PORTABLE bool update_fill_limit(B& body, int e);

/// Adds mass, momentum and moments of one point to the element's moments and node rows.
template <class B>
TALUS_PORTABLE void add_point_mass(B& body, int e, const double* fields);

/// Elastic energy [J] that the points of element `e` lose when it is full and its points share one stress; 0 otherwise.
template <class B>
TALUS_PORTABLE double find_sharing_loss(const B& body, const StepOptions<B::dimension>& options, int e);

/// Sets elements.apart of `e`: whether a point of the element keeps a gap.
template <class B>
TALUS_PORTABLE void note_gaps(B& body, const StepOptions<B::dimension>& options, int e);

// Contribution of a block to the nodal averages of the volumetric strain increment (2.94). B is a body of packs or of
// one GPU thread.

/// tr Δε of the elements of block `b`.
template <class B, class T = typename B::Lanes>
TALUS_PORTABLE T find_volumetric(const B& body, int b, double dt) {
  constexpr int D = B::dimension, width = B::width;
  const int* rows = &body.layout->connectivity[static_cast<std::size_t>(b) * width * (D + 1)];
  T v[D + 1][2 * D];
  TALUS_UNROLL
  for (int k = 0; k <= D; ++k) load_rows<2 * D, motion_stride<D>>(body.nodes.motion.data(), rows + k * width, v[k]);
  T divergence(0.0);
  const double* g = &body.layout->gradients[static_cast<std::size_t>(b) * D * D * width];
  TALUS_UNROLL
  for (int k = 0; k < D; ++k) {
    TALUS_UNROLL
    for (int d = 0; d < D; ++d) divergence += (v[k + 1][D + d] - v[0][D + d]) * load<T>(g + (k * D + d) * width);
  }
  return divergence * dt;
}

/// V_e times the value, and V_e, of the elements of block `b`; zero for elements that take no part.
template <class B, class T = typename B::Lanes>
TALUS_PORTABLE void find_average_parts(const B& body, int b, const StepOptions<B::dimension>& o, T* parts) {
  const std::size_t first = static_cast<std::size_t>(b) * B::width;
  const MaskOf<T> active = takes_part(body, first);
  const T V_e = select(active, load<T>(&body.layout->volumes[first]), T(0.0));
  T value = find_volumetric(body, b, o.dt);
  if (o.smoothing == input::Smoothing::stable) value -= load<T>(&body.elements.plastic_dilation[first]);
  parts[0] = V_e * select(active, value, T(0.0));
  parts[1] = V_e;
}

// Definitions of the functions declared above, element by element, for any number of lanes.

/// ∇ξ of element `e`.
template <class B>
TALUS_PORTABLE void read_gradients(const B& body, int e, double* g) {
  constexpr int D = B::dimension;
  const auto& gradients = body.mesh().gradients[static_cast<std::size_t>(e)];
  for (int i = 0; i < D * D; ++i) g[i] = gradients[static_cast<std::size_t>(i)];
}

/// Row in nodes.sums of the k-th node of element `e`.
template <int D>
double* sums_row(Body<D>& body, int e, int k) {
  const std::size_t b = static_cast<std::size_t>(e / lane_width), lane = static_cast<std::size_t>(e % lane_width);
  const int row = body.layout->connectivity[(b * (D + 1) + static_cast<std::size_t>(k)) * lane_width + lane];
  return &body.nodes.sums[static_cast<std::size_t>(row) * sums_stride];
}

template <class B>
TALUS_PORTABLE void add_internal_force(B& body, int e, bool mixed, double sign) {
  constexpr int D = B::dimension, width = B::width;
  using P = PointFields<D>;
  const auto& points = body.points;
  const int b = e / width, lane = e % width, n = static_cast<int>(points.count[e]);
  double stress[force_size<D>] = {}, volume = 0;
  bool uniform = true;
  int first_material = -1;
  for (int k = 0; k < n; ++k) {
    const double* p = points.slot(points.block_start[b] + k) + lane;
    const double v = p[P::volume * width];
    volume += v;
    for (int i = 0; i < force_size<D>; ++i) {
      stress[i] += v * p[(P::stress + force_component<D>(i)) * width];
    }
    const int m = points.material[points.id[static_cast<std::size_t>((points.block_start[b] + k) * width + lane)]];
    if (k == 0) first_material = m;
    uniform = uniform && m == first_material;
  }
  if (volume <= 0) return;
  const bool full = mixed && uniform && volume > body.elements.fill_limit[e];
  const double factor = sign * (full ? body.mesh().volumes[e] / volume : 1.0);
  for (double& s : stress) s *= factor;
  double g[D * D], out[D + 1][1 + 2 * D];
  read_gradients(body, e, g);
  ElementSums<D, double>::force_to_nodes(stress, g, out);
  for (int k = 0; k <= D; ++k) {
    double* row = sums_row(body, e, k);
    for (int d = 0; d < D; ++d) row[1 + D + d] += out[k][1 + D + d];
  }
}

template <class B>
TALUS_PORTABLE bool update_fill_limit(B& body, int e) {
  bool at_surface = false;
  for (int n : body.mesh().neighbours[e]) at_surface = at_surface || (n >= 0 && body.points.count[n] == 0);
  const double limit = at_surface ? full_share * body.mesh().volumes[e] : 0.0;
  const bool changed = body.elements.fill_limit[e] != limit;
  body.elements.fill_limit[e] = limit;
  return changed;
}

template <class B>
TALUS_PORTABLE double find_sharing_loss(const B& body, const StepOptions<B::dimension>& options, int e) {
  using P = PointFields<B::dimension>;
  constexpr int NS = P::stress_size, width = B::width;
  const auto& points = body.points;
  const std::int64_t first = points.block_start[e / width];
  const int n = static_cast<int>(points.count[e]);
  if (!options.mixed || n < 2) return 0;
  double mean[NS] = {}, volume = 0, energy = 0;
  const auto find_material = [&](int k) {
    const int id = points.id[static_cast<std::size_t>((first + k) * width + e % width)];
    return points.material[static_cast<std::size_t>(id)];
  };
  const int soil = find_material(0), states = count_states(body.laws, soil);
  double state[material::max_state_size] = {}, mean_state[material::max_state_size] = {};
  for (int k = 0; k < n; ++k) {
    if (find_material(k) != soil) return 0;
    const double* p = points.slot(first + k) + e % width;
    const double v = p[P::volume * width];
    double stress[NS];
    for (int i = 0; i < NS; ++i) {
      stress[i] = p[(P::stress + i) * width];
      mean[i] += v * stress[i];
    }
    for (int i = 0; i < states; ++i) {
      state[i] = p[(P::state + i) * width];
      mean_state[i] += v * state[i];
    }
    volume += v;
    energy += v * find_energy<NS>(body.laws, soil, stress, state);
  }
  if (!(volume > body.elements.fill_limit[e])) return 0;
  for (double& s : mean) s /= volume;
  for (double& s : mean_state) s /= volume;
  return energy - volume * find_energy<NS>(body.laws, soil, mean, mean_state);
}

template <class B>
TALUS_PORTABLE void note_gaps(B& body, const StepOptions<B::dimension>& options, int e) {
  using P = PointFields<B::dimension>;
  constexpr int width = B::width;
  const auto& points = body.points;
  const std::int64_t first = points.block_start[e / width];
  bool apart = false;
  for (int k = 0; options.moving && k < static_cast<int>(points.count[e]); ++k) {
    const double* p = points.slot(first + k) + e % width;
    const int id = points.id[static_cast<std::size_t>((first + k) * width + e % width)];
    const int soil = points.material[static_cast<std::size_t>(id)];
    double state[material::max_state_size];
    for (int i = 0; i < count_states(body.laws, soil); ++i) state[i] = p[(P::state + i) * width];
    apart = apart || find_gap(body.laws, soil, state) > 0;
  }
  body.elements.apart[static_cast<std::size_t>(e)] = apart ? 1 : 0;
}

template <class B>
TALUS_PORTABLE void add_point_mass(B& body, int e, const double* fields) {
  constexpr int D = B::dimension, width = B::width;
  using P = PointFields<D>;
  const double zero[P::stress_size] = {};
  double g[D * D] = {}, out[D + 1][1 + 2 * D];
  ElementSums<D, double> sums;
  sums.add(fields[P::mass], 0.0, fields + P::xi, fields + P::velocity, zero);
  sums.to_nodes(g, out);
  for (int k = 0; k <= D; ++k) {
    double* row = sums_row(body, e, k);
    for (int q = 0; q <= D; ++q) row[q] += out[k][q];
  }
  double* moments =
      &body.elements
           .moments[static_cast<std::size_t>(e / width) * moment_size<D> * width + static_cast<std::size_t>(e % width)];
  for (int i = 0; i < moment_size<D>; ++i) moments[i * width] += sums.moments[i];
}

/// P2G of an element whose rows are zero, from its points. `more_mass`: field of a mass that moves with the points
/// (pore water); -1: none.
template <class B>
TALUS_PORTABLE void gather_points(B& body, const StepOptions<B::dimension>& options, int e, int more_mass = -1) {
  using P = PointFields<B::dimension>;
  constexpr int width = B::width;
  const auto& points = body.points;
  const int n = static_cast<int>(points.count[e]);
  for (int k = 0; k < n; ++k) {
    const double* p = points.slot(points.block_start[e / width] + k) + e % width;
    double fields[P::state];
    for (int i = 0; i < P::state; ++i) fields[i] = p[i * width];
    if (more_mass >= 0) fields[P::mass] += p[more_mass * width];
    add_point_mass(body, e, fields);
  }
  if (options.smoothing != input::Smoothing::stable)  // they are not updated then
    body.elements.plastic_dilation[e] = body.elements.rough[e] = 0;
  if (n > 0) add_internal_force(body, e, options.mixed, 1);
}

/// Square of the critical step for the points of one element, and the element that decides it: `e` or one of its
/// neighbours, which the points may enter before the next evaluation. element is -1 where there are no points.
struct StepSquare {
  double dt2 = 0;  ///< [s²], without mass scaling
  int element = -1;
  TALUS_PORTABLE void add(const StepSquare& other) {
    if (other.element < 0 || std::isnan(dt2)) return;
    if (element < 0 || !(other.dt2 >= dt2)) *this = other;
  }
};
/// `more_mass`: field of a mass that moves with the points (pore water); -1: none.
template <class B>
TALUS_PORTABLE StepSquare find_step_square(const B& body, int e, int more_mass = -1) {
  using P = PointFields<B::dimension>;
  constexpr int NS = P::stress_size, width = B::width;
  const auto& points = body.points;
  const auto& mesh = body.mesh();
  const int b = e / width, lane = e % width;
  double speed2 = 0;  // of compression waves [m²/s²]
  for (int k = 0; k < static_cast<int>(points.count[e]); ++k) {
    const std::int64_t slot = points.block_start[b] + k;
    const double* p = points.slot(slot) + lane;
    const int soil = points.material[points.id[static_cast<std::size_t>(slot * width + lane)]];
    double sigma[NS], state[material::max_state_size];
    for (int i = 0; i < NS; ++i) sigma[i] = p[(P::stress + i) * width];
    for (int i = 0; i < count_states(body.laws, soil); ++i) state[i] = p[(P::state + i) * width];
    const double mass = p[P::mass * width] + (more_mass < 0 ? 0.0 : p[more_mass * width]);
    const double of_point = find_modulus(body.laws, soil, sigma, state) * p[P::volume * width] / mass;
    // NaN must win over any number; a point whose volume is negative has no real wave speed and yields NaN.
    if (!(of_point > 0 && of_point <= speed2) && !std::isnan(speed2)) speed2 = of_point > 0 ? of_point : NAN;
  }
  StepSquare least;
  if (speed2 == 0) return least;
  least = {mesh.altitudes[e] * mesh.altitudes[e] / speed2, e};
  for (int n : mesh.neighbours[e])
    if (n >= 0) least.add({mesh.altitudes[n] * mesh.altitudes[n] / speed2, n});
  return least;
}

}  // namespace talus::mpm
