// SPDX-License-Identifier: MIT
// Filter of null modes (theory 2). There are more points than nodes, so point velocities may have components with Σ_p
// m_p N_i v_p = 0 at every node. No force changes these null modes; points that cross elements create them, and they
// reappear as noise. The filter replaces the point velocities by v_p = Σ_i N_i u_i, where u has the points' momentum at
// every node, Σ_j M_ij u_j = Σ_p m_p N_i v_p (T2.5). Linear momentum is conserved exactly; affine motions, rotations
// among them, as far as the iteration for u converges.
#include "mpm/kernels/null_mode_kernels.hpp"

#include "mpm/kernels/averages.hpp"
#include "mpm/two_velocity/kernels.hpp"
#include "mpm/two_velocity/two_velocity_step.hpp"

namespace talus::mpm {

namespace {

/// Sums, moments and slot fields of one phase (soil or water).
template <int D, int SumsStride, int MassColumn, int MomentumColumn>
struct Phase {
  static constexpr int sums_stride = SumsStride, mass_column = MassColumn, momentum_column = MomentumColumn;
  AlignedVector<double>& sums;
  const AlignedVector<double>& moments;
  int mass_field, velocity_field;  ///< index in a slot
  int more_mass_field = -1;        ///< field of a mass that moves with the phase; -1: none
};

/// Calls work(node, sum) with the sum of the Count columns from First on over the rows of the node.
template <int Count, int Stride, int First, int D, class Work>
void for_nodes(const Body<D>& body, int threads, AlignedVector<double>& rows, Work&& work) {
  const Layout<D>& layout = *body.layout;
  update_and_for_node_pieces(body, threads, rows, Stride, [&](int begin, int end, int) {
    for (int i = begin; i < end; ++i) {
      double sum[Count] = {};
      for (int r = layout.row_start[i]; r < layout.row_start[i + 1]; ++r) {
        const double* row = &rows[static_cast<std::size_t>(layout.node_rows[r]) * Stride + First];
        for (int q = 0; q < Count; ++q) sum[q] += row[q];
      }
      work(i, sum);
    }
  });
}

/// Nodal velocities u that solve (T2.5), in rows.
template <int D, class P>
AlignedVector<double> solve_for_momentum(const Body<D>& body, int threads, const P& phase) {
  const Layout<D>& layout = *body.layout;
  const std::size_t nodes = body.mesh().nodes.size();
  const double cutoff = 1e-12 * body.smallest_mass;
  std::vector<double> inverse(nodes, 0);
  std::vector<Vec<D>> momentum(nodes), u(nodes), direction(nodes);
  AlignedVector<double> rows(static_cast<std::size_t>(layout.rows) * filter_stride, 0.0), product(rows.size(), 0.0);
  const auto give = [&](int i) {
    for (int r = layout.row_start[i]; r < layout.row_start[i + 1]; ++r) {
      for (int d = 0; d < D; ++d)
        rows[static_cast<std::size_t>(layout.node_rows[r]) * filter_stride + static_cast<std::size_t>(d)] = u[i][d];
    }
  };
  for_nodes<1, P::sums_stride, P::mass_column>(body, threads, phase.sums, [&](int i, const double* mass) {
    if (mass[0] > cutoff) inverse[static_cast<std::size_t>(i)] = 1 / mass[0];
  });
  for_nodes<D, P::sums_stride, P::momentum_column>(body, threads, phase.sums, [&](int i, const double* p) {
    for (int d = 0; d < D; ++d) {
      momentum[i][d] = p[d];
      u[i][d] = p[d] * inverse[i];
    }
    give(i);
  });
  for (const FilterWeights& weights : list_filter_weights()) {
    std::fill(product.begin(), product.end(), 0.0);
    for_blocks(body, threads, [&](int b, const int* at) {
      Pack value[D + 1][D], out[D + 1][D];
      multiply_mass(body, phase.moments, rows, b, value, out);
      for (int k = 0; k <= D; ++k) add_rows<D>(product.data(), at + k * lane_width, out[k]);
    });
    for_nodes<D, filter_stride, 0>(body, threads, product, [&](int i, const double* Mu) {
      for (int d = 0; d < D; ++d) {
        direction[i][d] = weights.keep * direction[i][d] + weights.step * (momentum[i][d] - Mu[d]) * inverse[i];
        u[i][d] += direction[i][d];
      }
      give(i);
    });
  }
  return rows;
}

template <int D, class P>
void filter_phase(Body<D>& body, const StepOptions<D>& o, const P& phase) {
  const Layout<D>& layout = *body.layout;
  const AlignedVector<double> rows = solve_for_momentum(body, o.threads, phase);
  std::vector<double> lost(static_cast<std::size_t>(layout.chunks), 0);
  for (std::size_t row = 0; row < static_cast<std::size_t>(layout.rows); ++row)
    std::fill_n(&phase.sums[row * P::sums_stride + P::momentum_column], D, 0.0);
  for_chunks(body, o.threads, [&](int c) {
    Pack kinetic(0.0);
    for (int b = layout.chunk_start[c]; b < layout.chunk_start[c + 1]; ++b) {
      if (body.points.block_used[b] == 0) continue;
      const int* at = &layout.connectivity[static_cast<std::size_t>(b) * lane_width * (D + 1)];
      Pack value[D + 1][D], out[D + 1][D];
      multiply_mass(body, phase.moments, rows, b, value, out);
      for (int k = 0; k <= D; ++k)
        add_rows<D, P::momentum_column, P::sums_stride>(phase.sums.data(), at + k * lane_width, out[k]);
      filter_points(body, b, value, {phase.mass_field, phase.velocity_field, phase.more_mass_field}, kinetic);
    }
    for (int l = 0; l < lane_width; ++l) lost[static_cast<std::size_t>(c)] += kinetic.value[l];
  });
  complete_chunks(body, lost);
  for (double e : lost) body.work.mapping += e;
}

}  // namespace

template <int D>
void filter_null_modes(Body<D>& body, const StepOptions<D>& o) {
  using P = Points<D>;
  if (!body.water.is_wet()) {
    filter_phase(body, o, Phase<D, sums_stride, 0, 1>{body.nodes.sums, body.elements.moments, P::mass, P::velocity});
    return;
  }
  using C = WetColumns<D>;
  using W = WaterFields<D>;
  Water<D>& water = body.water;
  if (o.darcy) {
    filter_phase(body, o,
                 Phase<D, sums_stride, 0, 1>{body.nodes.sums, body.elements.moments, P::mass, P::velocity,
                                             water.first_field + W::mass});
    return;
  }
  constexpr int stride = wet_sums_stride<D>;
  filter_phase(body, o,
               Phase<D, stride, C::mass, C::momentum>{water.sums, body.elements.moments, P::mass, P::velocity});
  filter_phase(body, o,
               Phase<D, stride, C::water_mass, C::water_momentum>{
                   water.sums, water.moments, water.first_field + W::mass, water.first_field + W::velocity});
}

template void filter_null_modes<2>(Body<2>&, const StepOptions<2>&);
template void filter_null_modes<3>(Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
