// SPDX-License-Identifier: MIT
#include "mpm/step/element_force.hpp"

#include "mpm/step/kernels.hpp"
#include "mpm/step/step.hpp"

namespace talus::mpm {
namespace {

/// ∇ξ of element `e`.
template <int D>
void read_gradients(const Body<D>& body, int e, double* g) {
  const auto& gradients = body.mesh().gradients[static_cast<std::size_t>(e)];
  for (int i = 0; i < D * D; ++i) g[i] = gradients[static_cast<std::size_t>(i)];
}

template <int D>
double* node_row(Body<D>& body, int e, int k) {
  const std::size_t b = static_cast<std::size_t>(e / lane_width), lane = static_cast<std::size_t>(e % lane_width);
  const int row = body.layout->connectivity[(b * (D + 1) + static_cast<std::size_t>(k)) * lane_width + lane];
  return &body.nodes.sums[static_cast<std::size_t>(row) * sums_stride];
}

}  // namespace

template <int D>
void add_internal_force(Body<D>& body, int e, bool mixed, double sign) {
  using P = Points<D>;
  const P& points = body.points;
  const int b = e / lane_width, lane = e % lane_width, n = static_cast<int>(points.count[e]);
  double stress[force_size<D>] = {}, volume = 0;
  bool uniform = true;
  int first_material = -1;
  for (int k = 0; k < n; ++k) {
    const double* p = points.slot(points.block_start[b] + k) + lane;
    const double v = p[P::volume * lane_width];
    volume += v;
    for (int i = 0; i < force_size<D>; ++i) {
      stress[i] += v * p[(P::stress + force_component<D>(i)) * lane_width];
    }
    const int m = points.material[points.id[static_cast<std::size_t>((points.block_start[b] + k) * lane_width + lane)]];
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
    double* row = node_row(body, e, k);
    for (int d = 0; d < D; ++d) row[1 + D + d] += out[k][1 + D + d];
  }
}

template <int D>
bool update_fill_limit(Body<D>& body, int e) {
  bool at_surface = false;
  for (int n : body.mesh().neighbours[e]) at_surface = at_surface || (n >= 0 && body.points.count[n] == 0);
  const double limit = at_surface ? full_share * body.mesh().volumes[e] : 0.0;
  const bool changed = body.elements.fill_limit[e] != limit;
  body.elements.fill_limit[e] = limit;
  return changed;
}

template <int D>
double find_sharing_loss(const Body<D>& body, const StepOptions<D>& options, int e) {
  using P = Points<D>;
  constexpr int NS = P::stress_size;
  const P& points = body.points;
  const std::int64_t first = points.block_start[e / lane_width];
  const int n = static_cast<int>(points.count[e]);
  if (!options.mixed || n < 2) return 0;
  std::array<double, NS> mean{};
  double volume = 0, energy = 0;
  const auto find_material = [&](int k) {
    const int id = points.id[static_cast<std::size_t>((first + k) * lane_width + e % lane_width)];
    return points.material[static_cast<std::size_t>(id)];
  };
  const material::Law& law = body.laws[find_material(0)];
  std::array<double, material::max_state_size> state{}, mean_state{};
  const int states = material::state_size(law);
  for (int k = 0; k < n; ++k) {
    if (find_material(k) != find_material(0)) return 0;
    const double* p = points.slot(first + k) + e % lane_width;
    const double v = p[P::volume * lane_width];
    std::array<double, NS> stress;
    for (int i = 0; i < NS; ++i) {
      stress[i] = p[(P::stress + i) * lane_width];
      mean[i] += v * stress[i];
    }
    for (int i = 0; i < states; ++i) {
      state[static_cast<std::size_t>(i)] = p[(P::state + i) * lane_width];
      mean_state[static_cast<std::size_t>(i)] += v * state[static_cast<std::size_t>(i)];
    }
    volume += v;
    energy += v * material::elastic_energy<NS>(law, stress.data(), state.data());
  }
  if (!(volume > body.elements.fill_limit[e])) return 0;
  for (double& s : mean) s /= volume;
  for (double& s : mean_state) s /= volume;
  return energy - volume * material::elastic_energy<NS>(law, mean.data(), mean_state.data());
}

template <int D>
void note_gaps(Body<D>& body, const StepOptions<D>& options, int e) {
  using P = Points<D>;
  const P& points = body.points;
  const std::int64_t first = points.block_start[e / lane_width];
  bool apart = false;
  for (int k = 0; options.moving && k < static_cast<int>(points.count[e]); ++k) {
    const double* p = points.slot(first + k) + e % lane_width;
    const int id = points.id[static_cast<std::size_t>((first + k) * lane_width + e % lane_width)];
    const material::Law& law = body.laws[points.material[static_cast<std::size_t>(id)]];
    double state[material::max_state_size];
    for (int i = 0; i < material::state_size(law); ++i) state[i] = p[(P::state + i) * lane_width];
    apart = apart || material::find_gap(law, state) > 0;
  }
  body.elements.apart[static_cast<std::size_t>(e)] = apart ? 1 : 0;
}

template <int D>
void add_point_mass(Body<D>& body, int e, const double* fields) {
  using P = Points<D>;
  const double zero[P::stress_size] = {};
  double g[D * D] = {}, out[D + 1][1 + 2 * D];
  ElementSums<D, double> sums;
  sums.add(fields[P::mass], 0.0, fields + P::xi, fields + P::velocity, zero);
  sums.to_nodes(g, out);
  for (int k = 0; k <= D; ++k) {
    double* row = node_row(body, e, k);
    for (int q = 0; q <= D; ++q) row[q] += out[k][q];
  }
  double* moments = &body.elements.moments[static_cast<std::size_t>(e / lane_width) * moment_size<D> * lane_width +
                                           static_cast<std::size_t>(e % lane_width)];
  for (int i = 0; i < moment_size<D>; ++i) moments[i * lane_width] += sums.moments[i];
}

template void add_internal_force<2>(Body<2>&, int, bool, double);
template void add_internal_force<3>(Body<3>&, int, bool, double);
template bool update_fill_limit<2>(Body<2>&, int);
template bool update_fill_limit<3>(Body<3>&, int);
template double find_sharing_loss<2>(const Body<2>&, const StepOptions<2>&, int);
template double find_sharing_loss<3>(const Body<3>&, const StepOptions<3>&, int);
template void note_gaps<2>(Body<2>&, const StepOptions<2>&, int);
template void note_gaps<3>(Body<3>&, const StepOptions<3>&, int);
template void add_point_mass<2>(Body<2>&, int, const double*);
template void add_point_mass<3>(Body<3>&, int, const double*);

}  // namespace talus::mpm
