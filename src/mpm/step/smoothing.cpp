// SPDX-License-Identifier: MIT
// Nodal averages of the volumetric strain increment of the elements, weighted by their volume (2.94).

#include "mpm/body/node_average.hpp"
#include "mpm/step/average_lines.hpp"

namespace talus::mpm {
// nodes.smoothed = Σ_e value_e V_e / Σ_e V_e over the elements at each node that take part.
template <int D>
void smooth_increments(Dry, Body<D>& body, const StepOptions<D>& o) {
  for_blocks_and_update(body, o.threads, body.nodes.average, 2, [&](int b, const int* rows) {
    Pack values[2];
    find_average_parts(body, b, o, values);
    add_average<D>(body.nodes.average, rows, values);
  });
  divide_averages<2, 1>(body, o.threads, body.nodes.average, body.nodes.smoothed.data());
}

template void smooth_increments<2>(Dry, Body<2>&, const StepOptions<2>&);
template void smooth_increments<3>(Dry, Body<3>&, const StepOptions<3>&);

}  // namespace talus::mpm
