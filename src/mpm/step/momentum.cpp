// SPDX-License-Identifier: MIT
// The two node loops of the step: accelerations, and MUSL's nodal velocities.

#include <algorithm>
#include <cmath>

#include "base/rows.hpp"
#include "mpm/body/node_rows.hpp"
#include "mpm/step/node_lines.hpp"

namespace talus::mpm {
template <int D>
void solve_momentum(Dry, Body<D>& body, const StepOptions<D>& o) {
  solve_pieces(body, o.threads, body.nodes.sums, sums_stride, o.monitor,
               [&](int begin, int end, PieceSums& sums) { solve_nodes(body, o, begin, end, sums); });
}

template <int D>
void remap_momentum(Dry, Body<D>& body, const StepOptions<D>& o) {
  const Layout<D>& layout = *body.layout;
  const bool far = body.points.size() > 50000;  // beyond the second-level cache
  for_chunks_and_update(body, o.threads, body.nodes.sums, sums_stride, [&](int c) {
    for (int b = layout.chunk_start[c]; b < layout.chunk_start[c + 1]; ++b) {
      if (body.points.block_used[b] == 0) continue;
      const int* rows = &layout.connectivity[static_cast<std::size_t>(b) * (D + 1) * lane_width];
      const double* moments = &body.elements.moments[static_cast<std::size_t>(b) * moment_size<D> * lane_width];
      if (far && b + 2 < layout.blocks) {
        const int* ahead = rows + 2 * (D + 1) * lane_width;
        for (int i = 0; i < (D + 1) * lane_width; ++i) {
          __builtin_prefetch(&body.nodes.motion[static_cast<std::size_t>(ahead[i]) * motion_stride<D>], 0, 3);
          __builtin_prefetch(&body.nodes.sums[static_cast<std::size_t>(ahead[i]) * sums_stride], 1, 3);
        }
        for (int i = 0; i < moment_size<D>; ++i)
          __builtin_prefetch(moments + (2 * moment_size<D> + i) * lane_width, 0, 3);
      }
      remap_block(body, b, o.dt);
    }
  });
  std::vector<std::array<double, 2>> works(static_cast<std::size_t>(layout.chunks));  // external, lost in the mapping
  for_node_pieces(body, o.threads, [&](int begin, int end, int c) {
    std::array<double, 2> lost{};
    remap_nodes(body, o, begin, end, lost);
    if (c < 0) return;
    works[static_cast<std::size_t>(c)] = lost;
  });
  complete_chunks(body, works);
  for (const auto& work : works) {
    body.work.external += work[0];
    body.work.mapping += work[1];
  }
  body.nodes.motion_step = o.dt;
}

template void solve_momentum<2>(Dry, Body<2>&, const StepOptions<2>&);
template void solve_momentum<3>(Dry, Body<3>&, const StepOptions<3>&);
template void remap_momentum<2>(Dry, Body<2>&, const StepOptions<2>&);
template void remap_momentum<3>(Dry, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
