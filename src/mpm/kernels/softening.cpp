// SPDX-License-Identifier: MIT
// Nonlocal averaging of softening (theory 23): search of neighbours, weights, and the correction of each element.
#include "mpm/kernels/softening.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/near_elements.hpp"
#include "mpm/state/partition.hpp"

namespace talus::mpm {
namespace {

/// Cut-off of the weight r exp(-r²) of (T23.1), in nonlocal lengths; the weight there is a twelfth of its maximum.
constexpr double farthest = 2;

/// Halo exchange: softened and softening_volume of the elements of other ranks within reach of this rank's elements.
template <int D>
void update_reach(Body<D>& body) {
  if (body.partition)
    body.partition->reach->update({as_halo(body.elements.softened), as_halo(body.elements.softening_volume)});
}

}  // namespace

template <int D>
SofteningReach find_softening_reach(const mesh::Mesh<D>& mesh, double length) {
  const mesh::NearElements<D> grid(mesh, farthest * length);
  SofteningReach reach;
  reach.start.push_back(0);
  for (int e = 0; e < mesh.element_count(); ++e) {
    grid.visit(e, [&](int other, double distance) {
      const double r = distance / length;
      if (other == e) return;
      reach.element.push_back(other);
      reach.weight.push_back(r * std::exp(-r * r));
    });
    reach.start.push_back(static_cast<std::int64_t>(reach.element.size()));
  }
  return reach;
}

template <int D>
void set_softening_length(Body<D>& body, double length) {
  body.softening_reach = std::make_shared<SofteningReach>(find_softening_reach(body.mesh(), length));
  Elements<D>& elements = body.elements;
  for (auto* field : {&elements.softened, &elements.softening_volume, &elements.nonlocal_correction})
    field->assign(elements.fill_limit.size(), 0.0);
}

template <int D>
void average_softening(Body<D>& body, int threads) {
  const SofteningReach& reach = *body.softening_reach;
  Elements<D>& elements = body.elements;
  const Layout<D>& layout = *body.layout;
  const auto for_elements = [&](auto&& work) {
    for_chunks(body, threads, [&](int c) {
      const int end =
          std::min(layout.chunk_start[static_cast<std::size_t>(c) + 1] * lane_width, body.mesh().element_count());
      for (int e = layout.chunk_start[static_cast<std::size_t>(c)] * lane_width; e < end; ++e)
        work(static_cast<std::size_t>(e));
    });
  };
  update_reach(body);
  for_elements([&](std::size_t e) { elements.nonlocal_correction[e] = find_nonlocal_correction(reach, elements, e); });
  for_elements([&](std::size_t e) { elements.softened[e] = elements.softening_volume[e] = 0; });
}

#define TALUS_INSTANTIATE(D)                                                     \
  template SofteningReach find_softening_reach<D>(const mesh::Mesh<D>&, double); \
  template void set_softening_length<D>(Body<D>&, double);                       \
  template void average_softening<D>(Body<D>&, int);
TALUS_INSTANTIATE(2)
TALUS_INSTANTIATE(3)
#undef TALUS_INSTANTIATE

}  // namespace talus::mpm
